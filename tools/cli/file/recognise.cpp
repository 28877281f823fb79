#include "recognise.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <system_error>

#include "geom/text/excerpt.h"
#include "geom/text/number.h"

namespace cli {
namespace {

using std::string_view_literals::operator""sv;

constexpr std::string_view kToCloud = "convert it to LAS, PLY or PCD, which skyway-cloud reads";
constexpr std::string_view kDroneToolsAndMesh = "skyway-check skyway-import-trajectory skyway-mesh";
constexpr std::string_view kDroneToolsAndFootprints =
    "skyway-check skyway-import-trajectory skyway-footprints";
constexpr std::string_view kUnpack = "unpack it first";
constexpr std::string_view kZippedShapes = "a Shapefile in a ZIP archive (.shz)";
constexpr std::string_view kUnpackShapes =
    "unpack it, and give skyway-footprints the .shp beside its other files";
constexpr std::string_view kToTrajectory =
    "convert its positions to a table id,x,y,z in metres, which skyway-check --paths-csv reads";
constexpr std::string_view kToKmz =
    "put it into a ZIP archive (.kmz) as wpmz/waylines.wpml, which skyway-check and "
    "skyway-import-trajectory read";
constexpr std::string_view kPathTools =
    "skyway-traj skyway-check skyway-replan skyway-plot skyway-view skyway-render skyway-map "
    "skyway-query skyway-info";
constexpr std::string_view kTrajectoryTools =
    "skyway-check skyway-export skyway-fly skyway-plot skyway-view skyway-render skyway-map "
    "skyway-query skyway-fleet skyway-info";
constexpr std::string_view kLogTools =
    "skyway-check skyway-plot skyway-view skyway-render skyway-map";
constexpr std::string_view kMapTools =
    "skyway-map skyway-plan skyway-replan skyway-lattice skyway-roadmap skyway-traj skyway-check "
    "skyway-export skyway-fly skyway-query skyway-plot skyway-view skyway-render skyway-bench "
    "skyway-info skyway-import-trajectory skyway-import-flight skyway-fleet";

struct Magic {
  std::size_t at;
  std::string_view bytes;
  std::string_view what;
  std::string_view tools;
  std::string_view otherwise;
};

// Longer and more telling ones first.
constexpr std::array kMagic = {
    Magic{0, "ASTM-E57"sv, "an E57 point cloud", "", kToCloud},
    Magic{0, "# .PCD"sv, "a PCD point cloud", "skyway-cloud", ""},
    Magic{0, "ply\n"sv, "a PLY file", "skyway-cloud skyway-mesh", ""},
    Magic{0, "ply\r"sv, "a PLY file", "skyway-cloud skyway-mesh", ""},
    Magic{0, "# Octomap OcTree binary"sv, "an OctoMap (.bt)", "skyway-import", ""},
    Magic{0, "# Octomap OcTree file"sv, "a full OctoMap (.ot)", "",
          "write it as .bt, which skyway-import reads"},
    Magic{0, "II*\0"sv, "a TIFF or GeoTIFF picture", "skyway-footprints", ""},
    Magic{0, "MM\0*"sv, "a TIFF or GeoTIFF picture", "skyway-footprints", ""},
    Magic{0, "II+\0"sv, "a TIFF or GeoTIFF picture", "skyway-footprints", ""},
    Magic{0, "MM\0+"sv, "a TIFF or GeoTIFF picture", "skyway-footprints", ""},
    Magic{0, "\0\0\x27\x0a"sv, "a Shapefile", "skyway-footprints", ""},
    Magic{0, "fgb\x03"sv, "a FlatGeobuf", "skyway-footprints", ""},
    Magic{4, "\x0a\x09OSMHeader"sv, "an OpenStreetMap extract (.osm.pbf)", "skyway-footprints", ""},
    Magic{0, "\x89HDF\r\n\x1a\n"sv, "an HDF5 file", "", ""},
    Magic{0, "ULog\x01\x12\x35"sv, "a PX4 flight log (ULog)", "skyway-import-flight", ""},
    Magic{0, "\xa3\x95\x80"sv, "an ArduPilot flight log (DataFlash .bin)", "", kToTrajectory},
    Magic{0, "#ROSBAG V"sv, "a ROS bag", "", kToTrajectory},
    Magic{0, "\x89MCAP0\r\n"sv, "an MCAP log", "", kToTrajectory},
    Magic{0, "QGC WPL"sv, "a mission (WPL)", kDroneTools, ""},
    Magic{0, "b3dm"sv, "a tile of 3D Tiles", "", "give skyway-mesh the tileset.json that names it"},
    Magic{0, "glTF"sv, "a binary glTF", kDroneToolsAndMesh, ""},
    Magic{0, "\x89PNG\r\n\x1a\n"sv, "a PNG picture", "skyway-view", ""},
    Magic{0, "\xff\xd8\xff"sv, "a JPEG picture", "", ""},
    Magic{0, "\x1f\x8b"sv, "a gzip archive", "", "unpack it with gunzip"},
    Magic{0, "BZh"sv, "a bzip2 archive", "", "unpack it with bunzip2"},
    Magic{0,
          "\xfd"
          "7zXZ\0"sv,
          "an xz archive", "", "unpack it with unxz"},
    Magic{0, "\x28\xb5\x2f\xfd"sv, "a Zstandard archive", "", "unpack it with unzstd"},
    Magic{0, "7z\xbc\xaf\x27\x1c"sv, "a 7-Zip archive", "", kUnpack},
    Magic{257, "ustar"sv, "a tar archive", "", kUnpack},
    Magic{0, "\x93NUMPY"sv, "a NumPy array (.npy)", "", ""},
    Magic{0, "PAR1"sv, "a Parquet table", "", "write it as CSV or GeoPackage"},
    Magic{0, "ARROW1"sv, "an Arrow table", "", "write it as CSV or GeoPackage"},
    Magic{0, "ISO-10303-21"sv, "an IFC or STEP model", "", ""},
    Magic{0, "%PDF"sv, "a PDF document", "", ""},
    Magic{0,
          "\x7f"
          "ELF"sv,
          "a program (ELF)", "", ""},
    Magic{0, "\xff\xfe\0\0"sv, "text in UTF-32", "", "write it as UTF-8"},
    Magic{0, "\xff\xfe"sv, "text in UTF-16", "", "write it as UTF-8"},
    Magic{0, "\xfe\xff"sv, "text in UTF-16", "", "write it as UTF-8"},
};

struct Word {
  std::string_view in;
  std::string_view what;
  std::string_view tools;
  std::string_view otherwise;
};

// In XML, by the elements.
constexpr std::array kElements = {
    Word{"<gpx", "a GPX track", "", kToTrajectory},
    Word{"<wpml:", "a DJI mission (WPML)", "", kToKmz},
    Word{"<kml", "a KML file", kDroneToolsAndFootprints, ""},
    Word{"<osm", "an OpenStreetMap file", "skyway-footprints", ""},
    Word{"CityModel", "a CityGML model", "skyway-footprints", ""},
    Word{"<COLLADA", "a COLLADA model", "skyway-mesh", ""},
    Word{"<sdf", "a Gazebo world (SDF)", "skyway-import", ""},
    Word{"<svg", "an SVG drawing", "", ""},
    Word{"<html", "an HTML page", "", ""},
    Word{"<HTML", "an HTML page", "", ""},
    Word{"<?xml", "an XML file", "", ""},
};

// In JSON, by keys and values without blanks between them.
constexpr std::array kJson = {
    Word{R"("type":"CityJSON")", "a CityJSON model", "skyway-footprints", ""},
    Word{R"("type":"CityJSONFeature")", "features of CityJSON without their first line", "",
         "put the CityJSON line of their sequence or service before them"},
    Word{R"("type":"path")", "a stream of paths", kPathTools, ""},
    Word{R"("type":"trajectory")", "a stream of trajectories", kTrajectoryTools, ""},
    Word{R"("type":"moving")", "a stream of obstacles that move",
         "skyway-check skyway-fleet skyway-info", ""},
    Word{R"("type":"tree")", "a stream with search trees",
         "skyway-plot skyway-view skyway-render skyway-map skyway-info", ""},
    Word{R"("type":"corridor")", "a stream of corridors", "skyway-view skyway-map skyway-info", ""},
    Word{R"("type":"certificate")", "a stream of certificates", "skyway-info", ""},
    Word{R"("type":"report")", "a stream of reports", "skyway-view skyway-info", ""},
    Word{R"("type":"answer")", "a stream of answers", "skyway-info", ""},
    Word{R"("fileType":"Plan")", "a QGroundControl plan", kDroneTools, ""},
    Word{R"("fileType":"GeoFence")", "a QGroundControl fence", "",
         "write its polygons as GeoJSON for skyway-map patch --keep-out"},
    Word{R"("type":"FeatureCollection")", "a GeoJSON file",
         "skyway-footprints skyway-map skyway-check skyway-import-trajectory skyway-plan "
         "skyway-bench",
         ""},
    Word{R"("type":"Feature")", "a GeoJSON feature",
         "skyway-footprints skyway-map skyway-plan skyway-bench", ""},
    Word{R"("type":"benchmark")", "a report of skyway-bench", "skyway-plot", ""},
    Word{R"("bounds":{"extents")", "a RotorPy world", "skyway-import", ""},
    Word{R"("tilt_max_deg":)", "a vehicle profile", "", "give it with --vehicle"},
    Word{R"("geometricError":)", "a tileset of 3D Tiles", "skyway-mesh", ""},
    Word{R"("bufferViews":)", "a glTF model", "skyway-mesh", ""},
    Word{R"("from":[)", "a stream of queries", "skyway-plan skyway-bench skyway-info", ""},
};

// In ZIP archives, by the name or the text of the first entry. A shard tells of what it is a part
// of.
constexpr std::array kZip = {
    Word{R"("format":"skyway-shard")", "a shard", "skyway-join skyway-fleet skyway-fly skyway-info",
         ""},
    Word{R"("format":"skyway-boxmap")", "a box map", kMapTools, ""},
    Word{R"("format":"skyway-roadmap")", "a roadmap",
         "skyway-plan skyway-replan skyway-roadmap skyway-bench skyway-info", ""},
    Word{
        R"("format":"skyway-lattice")", "a lattice",
        "skyway-plan skyway-replan skyway-lattice skyway-bench skyway-view skyway-plot skyway-info",
        ""},
    Word{"wpmz/", "a DJI mission (KMZ with WPML)", kDroneTools, ""},
    Word{".wpml", "a DJI mission (KMZ with WPML)", kDroneTools, ""},
    Word{".kml", "a KMZ file", "skyway-footprints", ""},
    Word{".shp", kZippedShapes, "", kUnpackShapes},
    Word{".shx", kZippedShapes, "", kUnpackShapes},
    Word{".dbf", kZippedShapes, "", kUnpackShapes},
    Word{".prj", kZippedShapes, "", kUnpackShapes},
    Word{".cpg", kZippedShapes, "", kUnpackShapes},
    Word{"[Content_Types].xml", "an office document", "", "write its table as CSV"},
    Word{"mimetype", "an office document", "", "write its table as CSV"},
    Word{".npy", "NumPy arrays (.npz)", "", ""},
};

FileKind kind_of(const Word& word) { return {std::string(word.what), word.tools, word.otherwise}; }

std::optional<FileKind> first_in(std::string_view text, const auto& words) {
  for (const Word& word : words) {
    if (text.find(word.in) != text.npos) return kind_of(word);
  }
  return std::nullopt;
}

std::uint8_t byte(std::string_view head, std::size_t at) {
  return at < head.size() ? static_cast<std::uint8_t>(head[at]) : 0;
}

// LAS; compressed where the highest bit of the point format says so.
FileKind las_kind(std::string_view head) {
  constexpr std::size_t kPointFormat = 104;
  const bool compressed = (byte(head, kPointFormat) & 0x80) != 0;
  if (!compressed) return {"a LAS point cloud", "skyway-cloud", ""};
  const bool copc = head.substr(0, 600).find("copc") != head.npos;
  return {copc ? "a COPC point cloud (LAZ)" : "a LAZ point cloud", "skyway-cloud", ""};
}

FileKind sqlite_kind(std::string_view head) {
  constexpr std::size_t kApplication = 68;
  if (head.size() > kApplication && head.substr(kApplication).starts_with("GP")) {
    return {"a GeoPackage", "skyway-footprints", ""};
  }
  return {"an SQLite database", "skyway-footprints", ""};
}

std::string without_blanks(std::string_view text) {
  std::string out;
  std::copy_if(text.begin(), text.end(), std::back_inserter(out),
               [](unsigned char c) { return !std::isspace(c); });
  return out;
}

FileKind zip_kind(std::string_view head) {
  constexpr std::size_t kNameSize = 26;
  constexpr std::size_t kName = 30;
  const std::size_t size = byte(head, kNameSize) + 256u * byte(head, kNameSize + 1);
  const auto name = head.substr(std::min(kName, head.size()), size);
  const bool ours = name == "meta.json";
  if (const auto known = first_in(ours ? without_blanks(head) : std::string(name), kZip))
    return *known;
  return {fmt::format("a ZIP archive whose first entry is \"{}\"", geom::excerpt(name, 40)), "",
          kUnpack};
}

// A telemetry log: MAVLink frames behind 8 bytes of microseconds since 1970.
bool is_tlog(std::string_view head) {
  const bool time = byte(head, 0) == 0 && byte(head, 1) >= 4 && byte(head, 1) <= 7;
  return time && (byte(head, 8) == 0xfe || byte(head, 8) == 0xfd);
}

// A fence in Mission Planner's words: items of the commands 5000 to 5004.
// A mission's text with no items but home, fences (MAV_CMD 5000 to 5004) or rally points (5100).
bool is_fence(std::string_view head) {
  if (!head.starts_with("QGC WPL")) return false;
  bool fence = false;
  for (std::size_t at = head.find('\n'); at < head.size(); at = head.find('\n', at + 1)) {
    std::size_t field = at + 1;
    for (int i = 0; i < 3; ++i) field = head.find('\t', std::min(field, head.size())) + 1;
    if (field == 0 || field >= head.size()) break;
    const std::string_view command = head.substr(field, 5);
    if (!fence && head.substr(at + 1).starts_with("0\t") && command.starts_with("16\t")) continue;
    if (command != "5100\t" && !(command.starts_with("500") && command.ends_with('\t')))
      return false;
    fence = true;
  }
  return fence;
}

// In plain text, by how it begins.
constexpr std::array kBeginnings = {
    Word{"min_x_m,", "a table of boxes (box CSV)", "skyway-import skyway-map", ""},
    Word{"voxel ", "a list of voxels (.3dmap)", "skyway-import", ""},
    Word{"boundary ", "a block text", "skyway-import", ""},
    Word{"solid ", "an STL model", "skyway-mesh", ""},
    Word{"- start:", "a jps3d map", "skyway-import", ""},
    Word{"- origin:", "a jps3d map", "skyway-import", ""},
    Word{"ncols ", "a height model (ASCII grid)", "skyway-footprints", ""},
    Word{"duration,x^0,", "a Crazyflie trajectory", kDroneTools, ""},
    Word{"t_s,east_m,", "a table of setpoints", kDroneTools, ""},
    Word{"t_s,x_m,", "a table of setpoints", kDroneTools, ""},
    Word{"id,t_s,east_m,", "a flight log", kLogTools, ""},
    Word{"id,t_s,x_m,", "a flight log", kLogTools, ""},
    Word{"id,from_x,", "a table of queries", "skyway-plan skyway-bench", ""},
    Word{"id,x,y,z", "a table of paths", kDroneTools, ""},
    Word{"command\n", "a Tello script", kDroneTools, ""},
};

// Three or four numbers, with blanks or commas between.
bool is_row_of_point(std::string_view line) {
  constexpr std::string_view kBetween = " \t\r,;";
  std::size_t numbers = 0;
  while (true) {
    line.remove_prefix(std::min(line.find_first_not_of(kBetween), line.size()));
    if (line.empty()) return numbers == 3 || numbers == 4;
    double value = 0;
    const auto [rest, error] = geom::read_number(line.data(), line.data() + line.size(), value);
    if (error != std::errc()) return false;
    ++numbers;
    line.remove_prefix(static_cast<std::size_t>(rest - line.data()));
    if (!line.empty() && kBetween.find(line.front()) == kBetween.npos) return false;
  }
}

// Two rows of numbers, behind one line of names at most.
bool is_table_of_points(std::string_view text) {
  const auto next = [&] {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return line;
  };
  const std::string_view first = next();
  if (!is_row_of_point(first) && first != "x y z" && first != "x,y,z") return false;
  return is_row_of_point(next());
}

std::optional<FileKind> text_kind(std::string_view head) {
  if (head.starts_with("\xef\xbb\xbf")) head.remove_prefix(3);
  head.remove_prefix(std::min(head.find_first_not_of(" \t\r\n"), head.size()));
  if (head.starts_with('<')) return first_in(head, kElements);
  if (head.starts_with('{') || head.starts_with('[')) return first_in(without_blanks(head), kJson);
  const auto start = head.substr(0, 2000);
  if (start.find("halfSizeX") != start.npos) {
    return FileKind{"an FCND table of boxes", "skyway-import", ""};
  }
  if (start.find("\nFIELDS ") != start.npos && start.find("\nDATA ") != start.npos) {
    return FileKind{"a PCD point cloud", "skyway-cloud", ""};
  }
  for (const Word& word : kBeginnings) {
    if (start.starts_with(word.in)) return kind_of(word);
  }
  if (is_table_of_points(start)) {
    return FileKind{"a table of points", "skyway-cloud skyway-check skyway-import-trajectory", ""};
  }
  return std::nullopt;
}

// The first bytes of a regular file; none of what is not one, so that nothing waits or is eaten.
std::string head_of(const std::string& path) {
  struct stat info {};
  if (stat(path.c_str(), &info) != 0 || !S_ISREG(info.st_mode)) return "";
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return "";
  std::string head(kHead, '\0');
  const ssize_t n = ::read(file, head.data(), head.size());
  ::close(file);
  head.resize(static_cast<std::size_t>(std::max<ssize_t>(n, 0)));
  return head;
}

}  // namespace

std::optional<FileKind> recognise(std::string_view head) {
  head = head.substr(0, kHead);
  if (head.starts_with("LASF")) return las_kind(head);
  if (head.starts_with("SQLite format 3\0"sv)) return sqlite_kind(head);
  if (head.starts_with("PK\x03\x04")) return zip_kind(head);
  if (is_fence(head)) {
    return FileKind{"a fence or rally points without a mission", "skyway-map",
                    "skyway-map patch --fence makes a fence part of a map"};
  }
  if (is_tlog(head)) return FileKind{"a telemetry log (tlog)", "", kToTrajectory};
  for (const Magic& magic : kMagic) {
    if (head.size() >= magic.at && head.substr(magic.at).starts_with(magic.bytes)) {
      return FileKind{std::string(magic.what), magic.tools, magic.otherwise};
    }
  }
  return text_kind(head);
}

std::optional<FileKind> recognise_file(const std::string& path) {
  const std::string head = head_of(path);
  const bool packed = head.starts_with("BZh") || head.starts_with("\x1f\x8b");
  if (packed && (path.ends_with(".osm.bz2") || path.ends_with(".osm.gz"))) {
    return FileKind{"a packed OpenStreetMap extract", "skyway-footprints", ""};
  }
  return recognise(head);
}

bool reads(std::string_view tools, std::string_view tool) {
  return fmt::format(" {} ", tools).find(fmt::format(" {} ", tool)) != std::string::npos;
}

}  // namespace cli
