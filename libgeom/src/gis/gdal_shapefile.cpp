#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <optional>

#include "gdal_whole.h"
#include "geom/base/error.h"

namespace geom::gis {
namespace {

constexpr std::size_t kHeader = 100;  // bytes of .shp and .shx (ESRI Shapefile, 1998, p. 3)

// A file as GDAL opens it.
class PartFile {
 public:
  PartFile(std::string path, const std::string& name) : path_(std::move(path)), name_(name) {
    file_.reset(gdal().open_file(path_.c_str(), "rb"));
    if (!file_) refuse("a readable copy", "one that cannot be opened");
    gdal().seek(file_.get(), 0, SEEK_END);
    size_ = gdal().tell(file_.get());
  }

  std::uint64_t size() const { return size_; }

  void read(std::uint64_t at, unsigned char* out, std::size_t size) const {
    const bool there = at + size <= size_ && gdal().seek(file_.get(), at, SEEK_SET) == 0 &&
                       gdal().read_file(out, 1, size, file_.get()) == size;
    if (!there) refuse(fmt::format("at least {} bytes", at + size), fmt::format("{}", size_));
  }

  // Numbers: big-endian as in .shp and .shx, little-endian as in .dbf.
  std::uint32_t big(std::uint64_t at) const {
    std::array<unsigned char, 4> b;
    read(at, b.data(), b.size());
    return std::uint32_t{b[0]} << 24 | std::uint32_t{b[1]} << 16 | std::uint32_t{b[2]} << 8 | b[3];
  }
  std::uint32_t little(std::uint64_t at, std::size_t bytes) const {
    std::array<unsigned char, 4> b{};
    read(at, b.data(), bytes);
    return std::uint32_t{b[3]} << 24 | std::uint32_t{b[2]} << 16 | std::uint32_t{b[1]} << 8 | b[0];
  }

  [[noreturn]] void refuse(const std::string& expected, const std::string& found) const {
    throw InputError(name_,
                     {.says = "the files of this shapefile do not belong together",
                      .expected = fmt::format("{} of {}", expected, gdal().name_of(path_.c_str())),
                      .found = found,
                      .advice = "get all of them again, or write it anew where it is whole"});
  }

 private:
  std::string path_;
  const std::string& name_;
  FileHandle file_;
  std::uint64_t size_ = 0;
};

// The length that a header of .shp or .shx says, bytes.
std::uint64_t stated_size(const PartFile& file) { return std::uint64_t{file.big(24)} * 2; }

void require_size(const PartFile& file) {
  if (stated_size(file) != file.size()) {
    file.refuse(fmt::format("the {} bytes that its header says", stated_size(file)),
                fmt::to_string(file.size()));
  }
}

// The index names the records one after the other, with nothing between or behind. Returns how
// many there are.
std::uint64_t require_index(const PartFile& shapes, const PartFile& index) {
  require_size(shapes);
  require_size(index);
  const std::uint64_t count = (index.size() - kHeader) / 8;
  std::uint64_t next = kHeader;
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::uint64_t at = std::uint64_t{index.big(kHeader + 8 * i)} * 2;
    const std::uint64_t size = std::uint64_t{index.big(kHeader + 8 * i + 4)} * 2;
    if (at != next) {
      index.refuse(fmt::format("record {} at byte {}", i + 1, next), fmt::format("byte {}", at));
    }
    const std::uint64_t own = std::uint64_t{shapes.big(at + 4)} * 2;
    if (own != size) {
      index.refuse(fmt::format("record {} to have the {} bytes that it has", i + 1, own),
                   fmt::to_string(size));
    }
    next = at + 8 + size;
  }
  if (next != shapes.size()) {
    index.refuse(fmt::format("records up to byte {}", shapes.size()),
                 fmt::format("their end at byte {}, after {}", next, count));
  }
  return count;
}

// Where the parts of a patch are (ESRI Shapefile, 1998, p. 20): their number, and behind the first
// points of each their kinds.
constexpr std::uint64_t kParts = 36;
constexpr std::uint64_t kFirstPoints = 44;

enum PatchPart : std::uint32_t { outer_ring = 2, inner_ring = 3, first_ring = 4, ring = 5 };

// GDAL takes every ring behind another for a hole of that, unless it is called an Outer or a First
// Ring. A Ring is one only behind a First Ring; else it is an outline of its own (p. 21).
void require_rings(const PartFile& shapes, std::uint64_t record, std::uint64_t number,
                   const std::string& name) {
  const std::uint64_t parts = shapes.little(record + kParts, 4);
  constexpr std::uint32_t kLastKind = 6;
  std::uint32_t of = 0;  // the kind of ring that those right before this one began with
  bool any = false;      // rings before it
  for (std::uint64_t i = 0; i < parts; ++i) {
    const std::uint32_t kind = shapes.little(record + kFirstPoints + 4 * (parts + i), 4);
    const bool mistaken = (kind == ring && any && of != first_ring) ||
                          (kind == inner_ring && of != outer_ring) || kind > kLastKind;
    if (mistaken) {
      throw InputError(
          name, {.item = fmt::format("part {} of patch {}", i + 1, number),
                 .expected = "outer rings that are called so, and their holes right behind them",
                 .found = fmt::format("a part of kind {} without", kind),
                 .advice = "GDAL would take it for a hole: export the surfaces as triangles, or in "
                           "another format, as CityGML or OBJ"});
    }
    if (kind != ring && kind != inner_ring) of = kind;
    any |= kind >= outer_ring && kind <= ring;
  }
}

void require_patches(const PartFile& shapes, const PartFile& index, const std::string& name) {
  constexpr std::uint64_t kShapeType = 32;
  constexpr std::uint32_t kMultiPatch = 31;
  if (shapes.little(kShapeType, 4) != kMultiPatch) return;
  for (std::uint64_t i = 0; kHeader + 8 * (i + 1) <= index.size(); ++i) {
    const std::uint64_t record = std::uint64_t{index.big(kHeader + 8 * i)} * 2 + 8;
    if (shapes.little(record, 4) == kMultiPatch) require_rings(shapes, record, i + 1, name);
  }
}

void require_rows(const PartFile& table, std::uint64_t shapes, const std::string& name) {
  const std::uint64_t rows = table.little(4, 4);
  const std::uint64_t first = table.little(8, 2);
  const std::uint64_t size = table.little(10, 2);
  if (rows != shapes) {
    table.refuse(fmt::format("a row for each of the {} shapes", shapes), fmt::to_string(rows));
  }
  if (table.size() < first + rows * size) {
    table.refuse(fmt::format("at least {} bytes", first + rows * size),
                 fmt::to_string(table.size()));
  }
  for (std::uint64_t i = 0; i < rows; ++i) {
    if (table.little(first + i * size, 1) != '*') continue;
    throw InputError(name, {.says = fmt::format(
                                "row {} of its table is marked as deleted, but its shape is still "
                                "there: GDAL leaves it out, other programs do not; settle it with "
                                "`ogrinfo city.shp -sql \"REPACK city\"`, or write the file anew",
                                i + 1)});
  }
}

std::string lower_extension(const std::string& path) {
  std::string end = gdal().extension_of(path.c_str());
  std::transform(end.begin(), end.end(), end.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return end;
}

}  // namespace

void require_whole_shapefile(const DatasetHandle& dataset, const std::string& name) {
  const ListHandle files(gdal().files_of(dataset.get()));
  const auto path_of = [&](const char* end) -> std::optional<std::string> {
    for (char** file = files.get(); file && *file; ++file) {
      if (lower_extension(*file) == end) return *file;
    }
    return std::nullopt;
  };
  const auto shp = path_of("shp");
  const auto shx = path_of("shx");
  const auto dbf = path_of("dbf");
  if (!shp || !shx || !dbf) {
    throw InputError(name, {.says = fmt::format(
                                "a shapefile is three files of one name, and the .{} is not there",
                                !shp   ? "shp (the shapes)"
                                : !shx ? "shx (their index)"
                                       : "dbf (their attributes)"),
                            .advice = "copy it beside the others"});
  }
  const std::uint64_t shapes = require_index(PartFile(*shp, name), PartFile(*shx, name));
  require_patches(PartFile(*shp, name), PartFile(*shx, name), name);
  require_rows(PartFile(*dbf, name), shapes, name);
}

Fault unopened(const std::string& path) {
  if (lower_extension(path) == "shp") {
    const std::string shx = gdal().stem_of(path.c_str()) + std::string(".shx");
    VSIStatBufL about;
    const auto beside = [&](const char* end) {
      return gdal().stat(gdal().with_extension(path.c_str(), end), &about) == 0;
    };
    if (!beside("shx") && !beside("SHX")) {
      return {
          .says = fmt::format("this is the .shp of a shapefile, and its index {} is not beside it",
                              shx),
          .advice = fmt::format("copy all its files into one folder, or make the index anew with "
                                "`ogrinfo --config SHAPE_RESTORE_SHX YES {}`",
                                gdal().name_of(path.c_str()))};
    }
  }
  return {.expected =
              "footprints that GDAL reads (GeoJSON, GeoPackage, Shapefile, FlatGeobuf), "
              "CityJSON, OSM .pbf or a GeoTIFF",
          .found = "a file that GDAL cannot open"};
}

}  // namespace geom::gis
