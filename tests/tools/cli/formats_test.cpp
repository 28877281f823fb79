// The tables of formats together: a new row needs a sample here, and a line in docs/formats.md.

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "cli/content/drone_file.h"
#include "cli/file/files.h"
#include "geom/base/error.h"
#include "geom/cloud/cloud_format.h"
#include "geom/gis/footprint_format.h"
#include "geom/import/import_boxes.h"
#include "geom/model/model_format.h"
#include "geom/zone/read_zones.h"
#include "traj/files/drone_formats.h"
#include "traj/files/foreign_formats.h"
#include "traj/files/own_formats.h"
#include "traj/files/recognise.h"

namespace traj::files {
namespace {

using geom::Format;
using std::string_literals::operator""s;

std::string zip(const std::string& name, const std::string& content = {}) {
  std::string head = "PK\x03\x04" + std::string(22, '\0');
  head += static_cast<char>(name.size());
  head += std::string(3, '\0');
  return head + name + content;
}

std::string archive(const std::string& format) {
  return zip("meta.json", "{\"format\":\"" + format + "\"}");
}

std::string record(const std::string& type) { return "{\"type\":\"" + type + "\",\"id\":\"a\"}\n"; }

std::string las(char format, const std::string& more = {}) {
  std::string head = "LASF" + std::string(371, '\0');
  head[104] = format;
  return head + more;
}

// How a file of each format begins, by what it is.
const std::map<std::string_view, std::string> kSamples = {
    {"a shard", archive("skyway-shard")},
    {"a box map", archive("skyway-boxmap")},
    {"a roadmap", archive("skyway-roadmap")},
    {"a lattice", archive("skyway-lattice")},
    {"the ground of a map", archive("skyway-ground")},
    {"a stream of paths", record("path")},
    {"a stream of trajectories", record("trajectory")},
    {"a stream of obstacles that move", record("moving")},
    {"a stream with search trees", record("tree")},
    {"a stream of corridors", record("corridor")},
    {"a stream of certificates", record("certificate")},
    {"a stream of reports", record("report")},
    {"a stream of ways home (contingencies)", record("contingency")},
    {"a stream of simulated flights", record("flight")},
    {"a stream of answers", record("answer")},
    {"a stream of queries", R"({"id":"a","from":[0,0,10],"to":[50,20,10]})"},
    {"a table of queries", "id,from_x,from_y,from_z,to_x,to_y,to_z\n"},
    {"a flight log", "id,t_s,east_m,north_m,up_m\n"},
    {"a report of skyway-bench", record("benchmark")},
    {"a vehicle profile", R"({"name":"quad","tilt_max_deg":35})"},
    {"a Crazyflie trajectory", "duration,x^0,x^1\n"},
    {"a table of setpoints", "t_s,east_m,north_m,up_m\n"},
    {"a Tello script", "command\ntakeoff\n"},
    {"a mission (WPL)", "QGC WPL 110\n0\t1\t0\t16\t0\n1\t0\t3\t22\t0\n"},
    {"a QGroundControl plan", R"({"fileType":"Plan","version":1})"},
    {"a DJI mission (KMZ with WPML)", zip("wpmz/template.kml")},
    {"a KML file", "<?xml version=\"1.0\"?>\n<kml xmlns=\"http://www.opengis.net/kml/2.2\">"},
    {"a GeoJSON file", R"({"type":"FeatureCollection","features":[)"},
    {"a binary glTF", "glTF\x02"s},
    {"a table of paths", "id,x,y,z\na,1,2,3\n"},
    {"an FCND table of boxes", "lat0 37, lon0 -122\nposX,posY,posZ,halfSizeX,halfSizeY\n"},
    {"a table of boxes (box CSV)", "min_x_m,min_y_m,min_z_m,max_x_m,max_y_m,max_z_m,label\n"},
    {"a block text", "boundary 0 0 0 1 1 1\n"},
    {"a RotorPy world", R"({"bounds":{"extents":[0,1,0,1,0,1]},"blocks":[]})"},
    {"a list of voxels (.3dmap)", "voxel 4 5 6\n"},
    {"an OctoMap (.bt)", "# Octomap OcTree binary file\n"},
    {"a Gazebo world (SDF)", "<?xml version=\"1.0\"?>\n<sdf version=\"1.9\">"},
    {"a jps3d map", "- origin: [0, 0, 0]\n"},
    {"a PCD point cloud", "# .PCD v0.7\n"},
    {"a PLY file", "ply\nformat ascii 1.0\n"},
    {"a LAS point cloud", las(3)},
    {"a LAZ point cloud", las('\x83')},
    {"a COPC point cloud (LAZ)", las('\x86', "\0\0copc"s)},
    {"a table of points", "1 2 3\n4 5 6\n"},
    {"an STL model", "solid house\nfacet normal 0 0 1\n"},
    {"a tileset of 3D Tiles", R"({"asset":{"version":"1.1"},"geometricError":5,"root":{}})"},
    {"a glTF model", R"({"asset":{"version":"2.0"},"bufferViews":[]})"},
    {"a COLLADA model", "<?xml version=\"1.0\"?>\n<COLLADA version=\"1.4.1\">"},
    {"a Shapefile", "\0\0\x27\x0a\0"s},
    {"a FlatGeobuf",
     "fgb\x03"
     "fgb"s},
    {"a GeoPackage", "SQLite format 3\0"s + std::string(52, '\0') + "GPKG"},
    {"an SQLite database", "SQLite format 3\0"s + std::string(90, '\0')},
    {"a GeoJSON feature", R"({"type":"Feature","geometry":{)"},
    {"a KMZ file", zip("doc.kml")},
    {"a GML file", "<?xml?><c xmlns:gml=\"http://www.opengis.net/gml/3.2\">"},
    {"an OpenStreetMap file", "<?xml version='1.0'?>\n<osm version=\"0.6\">"},
    {"an OpenStreetMap extract (.osm.pbf)", "\0\0\0\x0d\x0a\x09OSMHeader"s},
    {"a CityJSON model", R"({"type":"CityJSON","version":"2.0"})"},
    {"a CityGML model", "<?xml version=\"1.0\"?><core:CityModel xmlns"},
    {"a TIFF or GeoTIFF picture", "II*\0\x08"s},
    {"a height model (ASCII grid)", "ncols 4\n"},
    {"an E57 point cloud", "ASTM-E57\1"s},
    {"a full OctoMap (.ot)", "# Octomap OcTree file\n"},
    {"features of CityJSON without their first line", R"({"type":"CityJSONFeature"})"},
    {"a Shapefile in a ZIP archive (.shz)", zip("streets.dbf")},
    {"a tile of 3D Tiles", "b3dm\1"s},
    {"an IFC or STEP model", "ISO-10303-21;\n"},
    {"a fence or rally points without a mission", "QGC WPL 110\n0\t1\t0\t5001\t4\t"},
    {"a PX4 flight log (ULog)", "ULog\x01\x12\x35\x01"},
    {"an ArduPilot flight log (DataFlash .bin)", "\xa3\x95\x80\x80"},
    {"a ROS bag", "#ROSBAG V2.0\n"},
    {"an MCAP log", "\x89MCAP0\r\n"},
    {"a telemetry log (tlog)", "\0\x05\xe1\x02\x03\x04\x05\x06\xfd\x09"s},
    {"a GPX track", "<?xml version=\"1.0\"?><gpx version=\"1.1\">"},
    {"a DJI mission (WPML)", "<?xml?><kml xmlns:wpml=\"x\"><wpml:missionConfig>"},
    {"a QGroundControl fence", R"({"fileType":"GeoFence"})"},
    {"a PNG picture", "\x89PNG\r\n\x1a\n"},
    {"a JPEG picture", "\xff\xd8\xff\xe0"},
    {"a PDF document", "%PDF-1.7"},
    {"an SVG drawing", "<?xml?><svg>"},
    {"an HTML page", "<!doctype html><html>"},
    {"an HDF5 file", "\x89HDF\r\n\x1a\n"},
    {"a NumPy array (.npy)", "\x93NUMPY\x01"},
    {"NumPy arrays (.npz)", zip("boxes.npy")},
    {"a Parquet table", "PAR1"},
    {"an Arrow table", "ARROW1"},
    {"an office document", zip("mimetype")},
    {"a gzip archive", "\x1f\x8b\x08"},
    {"a bzip2 archive", "BZh9"},
    {"an xz archive",
     "\xfd"
     "7zXZ\0"s},
    {"a Zstandard archive", "\x28\xb5\x2f\xfd"},
    {"a 7-Zip archive", "7z\xbc\xaf\x27\x1c"},
    {"a tar archive", std::string(257, 'a') + "ustar"},
    {"a program (ELF)",
     "\x7f"
     "ELF\x02"s},
    {"text in UTF-32", "\xff\xfe\0\0{"s},
    {"text in UTF-16", "\xff\xfe{\0"s},
    {"an XML file", "<?xml version=\"1.0\"?>\n<note>"},
    {"a ZIP archive", zip("a.txt")},
};

// A format, and its word in the options of the table's tools; empty where it has none.
struct Entry {
  const Format* format;
  std::string_view word;
};

struct Table {
  std::string name;
  std::vector<Entry> entries;
  std::string tool;  // that reads all of them; empty: each says its own
};

std::vector<Entry> entries_of(geom::Formats formats) {
  std::vector<Entry> out;
  for (const Format* format : formats) out.push_back({format, format->word});
  return out;
}

// A kind has the word of its row.
template <class Row>
std::vector<Entry> rows_of(geom::FormatRows<Row> rows) {
  std::vector<Entry> out;
  for (const Row* row : rows) {
    out.push_back({row->format, row->format->word});
    for (const Format* kind : row->kinds) out.push_back({kind, row->format->word});
  }
  return out;
}

std::vector<Table> tables() {
  return {{"Skyway's own files", entries_of(own_formats()), ""},
          {"zones of airspace", entries_of(geom::zone_formats()), "skyway-map"},
          {"drones' files", entries_of(drone_formats()), "skyway-check"},
          {"boxes and worlds", rows_of(geom::box_formats()), "skyway-import"},
          {"point clouds", rows_of(geom::cloud_formats()), "skyway-cloud"},
          {"models", rows_of(geom::model_formats()), "skyway-mesh"},
          {"footprints", rows_of(geom::gis::footprint_formats()), "skyway-footprints"},
          {"other files", entries_of(foreign_formats()), ""}};
}

TEST(Formats, AreRecognisedByTheirOwnRowFirst) {
  std::set<std::string_view> seen;
  for (const Format* format : all_formats()) {
    seen.insert(format->what);
    if (!format->begins) continue;
    const auto sample = kSamples.find(format->what);
    ASSERT_NE(sample, kSamples.end()) << "no sample of " << format->what;
    EXPECT_TRUE(format->begins(sample->second)) << format->what;
    const Format* const found = recognise(sample->second);
    EXPECT_EQ(found, format) << format->what << " is taken for "
                             << (found ? found->what : "nothing");
  }
  for (const auto& [what, sample] : kSamples) EXPECT_TRUE(seen.contains(what)) << what;
}

// What skyway-check takes FILE for: what it is, and nothing else for one of these.
TEST(Formats, AreSettledAsWhatTheyAre) {
  const std::string path = ::testing::TempDir() + "sample";
  for (const auto& [what, sample] : kSamples) {
    std::ofstream(path, std::ios::binary) << sample;
    const Format* const format = recognise(sample);
    for (const char* asked : {"", cli::kAuto, cli::kRecordsWord, "wpl"}) {
      cli::DroneFileOptions options{.format = asked};
      cli::InputFile file(path);
      options.settle(file);
      const bool open = asked == std::string_view("") || asked == std::string_view(cli::kAuto);
      const std::string settled = is_drone_format(format) ? cli::kAuto
                                  : format == &kFlightLog ? cli::kFlightLogWord
                                  : format == &kPaths || format == &kTrajectories ? ""
                                                                                  : asked;
      const std::string insisted = asked == std::string_view(cli::kRecordsWord) ? "" : asked;
      EXPECT_EQ(options.format, open ? settled : insisted) << what << ", asked: " << asked;
      EXPECT_EQ(file.read_all(), sample) << "the beginning stays to be read";
    }
  }
  std::filesystem::remove(path);
}

// A sample that two rows know would depend on the order of the tables.
TEST(Formats, AreKnownByOneRowOnly) {
  const std::set<std::string_view> any = {"an XML file", "a ZIP archive", "text in UTF-16",
                                          "an HTML page"};
  for (const Format* format : all_formats()) {
    if (any.contains(format->what)) continue;
    for (const auto& [what, sample] : kSamples) {
      if (what == format->what || !format->begins) continue;
      EXPECT_FALSE(format->begins(sample)) << what << " is also " << format->what;
    }
  }
}

TEST(Formats, AreNamedOnce) {
  std::map<std::string_view, const Format*> named;
  for (const Format* format : all_formats()) {
    EXPECT_FALSE(format->what.empty());
    EXPECT_EQ(named.emplace(format->what, format).first->second, format) << format->what;
  }
}

TEST(Formats, HaveWordsThatAreUniqueInTheirTable) {
  const auto expect_unique = [](const std::vector<std::string_view>& words) {
    std::set<std::string_view> seen;
    for (const std::string_view word : words) {
      EXPECT_FALSE(word.empty());
      EXPECT_NE(word, "auto");
      EXPECT_TRUE(seen.insert(word).second) << word;
    }
  };
  expect_unique(geom::words_of(geom::box_formats()));
  expect_unique(geom::words_of(geom::cloud_formats()));
  expect_unique(geom::words_of(geom::model_formats()));
  expect_unique(geom::words_of(geom::gis::footprint_formats()));
  std::vector<std::string_view> drone;
  for (const Format* format : drone_formats()) drone.push_back(format->word);
  expect_unique(drone);
}

TEST(Formats, AreReadByTheToolOfTheirTable) {
  for (const Table& table : tables()) {
    for (const Entry& entry : table.entries) {
      if (table.tool.empty()) continue;
      EXPECT_TRUE(geom::reads(table.tool, *entry.format))
          << table.tool << " and " << entry.format->what;
    }
  }
}

TEST(Formats, NameToolsThatThereAre) {
  for (const Format* format : all_formats()) {
    for (const std::string_view tool : format->readers) {
      ASSERT_TRUE(tool.starts_with("skyway-")) << tool;
      std::string folder(tool.substr(7));
      std::replace(folder.begin(), folder.end(), '-', '_');
      const auto path = std::filesystem::path(SKYWAY_SOURCE_DIR) / "tools" / folder / "main.cpp";
      EXPECT_TRUE(std::filesystem::exists(path)) << format->what << ": " << tool;
    }
  }
}

// What a tool reads by --format auto is what messages call the file.
TEST(Formats, AreReadAsWhatTheyAreCalled) {
  for (const auto* row : geom::box_formats()) {
    EXPECT_EQ(&geom::box_format_of(kSamples.at(row->format->what), "it"), row) << row->format->what;
  }
  for (const auto* row : geom::cloud_formats()) {
    EXPECT_EQ(geom::row_recognised(kSamples.at(row->format->what), geom::cloud_formats()), row);
    for (const Format* kind : row->kinds) {
      EXPECT_EQ(geom::row_recognised(kSamples.at(kind->what), geom::cloud_formats()), row)
          << kind->what;
    }
  }
  for (const auto* row : geom::model_formats()) {
    const std::string name = "model" + std::string(row->ending);
    const auto sample = kSamples.find(row->format->what);
    const std::string bytes = sample == kSamples.end() ? "?" : sample->second;
    EXPECT_EQ(&geom::model_format_of(bytes, name), row) << name;
    for (const Format* kind : row->kinds) {
      EXPECT_EQ(&geom::model_format_of(kSamples.at(kind->what), "it"), row) << kind->what;
    }
  }
}

TEST(Formats, OfDronesAreThoseThatAreFlown) {
  for (const Format* format : drone_formats()) EXPECT_TRUE(is_drone_format(format)) << format->what;
  for (const Format* format : all_formats()) {
    if (!is_drone_format(format)) continue;
    EXPECT_TRUE(geom::reads("skyway-check", *format)) << format->what;
  }
  EXPECT_FALSE(is_drone_format(nullptr));
}

TEST(Formats, ThatNobodyReadsHaveNoWord) {
  for (const Format* format : foreign_formats()) EXPECT_EQ(format->word, "") << format->what;
}

// The lines of a table of docs/formats.md.
std::string lines_of(const Table& table) {
  std::string out;
  for (const auto& [format, word] : table.entries) {
    std::string use = fmt::format("{}", fmt::join(format->readers, ", "));
    if (!format->advice.empty()) use += (use.empty() ? "" : "; ") + std::string(format->advice);
    const std::string named = word.empty() ? "" : fmt::format("`{}`", word);
    out += fmt::format("| {} | {} | {} |\n", format->what, named, use);
  }
  return out;
}

TEST(Formats, StandInTheDocuments) {
  std::ifstream file(std::filesystem::path(SKYWAY_SOURCE_DIR) / "docs/formats.md");
  const std::string text(std::istreambuf_iterator<char>(file), {});
  for (const Table& table : tables()) {
    const std::string lines = lines_of(table);
    EXPECT_NE(text.find(lines), std::string::npos)
        << "docs/formats.md lacks, of " << table.name << ":\n"
        << lines;
  }
}

}  // namespace
}  // namespace traj::files
