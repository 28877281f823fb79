#include "gdal_whole_raster.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <set>
#include <string_view>

#include "gdal_gaps.h"
#include "gdal_mosaic.h"
#include "geom/text/counted.h"
#include "geom/text/text_table.h"

namespace geom::gis {
namespace {

// GDAL's names of the formats whose numbers and holes it gives as the file has them.
constexpr std::string_view kWhole[] = {"GTiff",   "VRT",  "AAIGrid", "HFA",
                                       "SRTMHGT", "DTED", "EHdr",    "GPKG"};

void require_whole_format(std::string_view driver, const std::string& name) {
  if (std::find(std::begin(kWhole), std::end(kWhole), driver) != std::end(kWhole)) return;
  throw InputError(
      name, {.expected = "a raster of numbers as GeoTIFF, ASCII grid, Erdas Imagine, SRTM, DTED or "
                         "Esri .flt",
             .found = fmt::format("a format that may not keep numbers or holes ({})", driver),
             .advice = "look at what it holds, and write it as GeoTIFF, for example with "
                       "`gdal_translate -a_nodata -9999 in out.tif`"});
}

// Pictures of one file, as pages of a TIFF: their names, each followed by a description.
void require_one_picture(const DatasetHandle& dataset, const std::string& name) {
  char** const pictures = gdal().metadata(dataset.get(), "SUBDATASETS");
  std::size_t count = 0;
  for (char** entry = pictures; entry && *entry; ++entry) ++count;
  if (count == 0) return;
  throw InputError(
      name, {.expected = "one raster in the file",
             .found = fmt::format("{}, of which GDAL would read the first alone", count / 2),
             .advice = "take them out one by one: `gdalinfo` has their names, and `gdal_translate "
                       "NAME out.tif` writes one"});
}

// Compression made for pictures changes heights by many metres.
void require_exact_numbers(const DatasetHandle& dataset, const std::string& name) {
  char** const entries = gdal().metadata(dataset.get(), "IMAGE_STRUCTURE");
  for (char** entry = entries; entry && *entry; ++entry) {
    const std::string_view text = *entry;
    const bool compression = text.starts_with("COMPRESSION");
    if (!compression || (text.find("JPEG") == text.npos && text.find("LOSSY") == text.npos)) {
      continue;
    }
    throw InputError(name, {.expected = "numbers that compression does not change",
                            .found = std::string(text),
                            .advice = "get the heights as they were before, from whoever made it"});
  }
}

bool is_picture_of_its_own(const std::string& file) {
  return !EQUAL(gdal().extension_of(file.c_str()), "ovr") &&
         !EQUAL(gdal().extension_of(file.c_str()), "msk");
}

// Also of each file that a mosaic names: its gaps are 0 before the mosaic's value for none counts.
void require_no_gaps(const DatasetHandle& dataset, const std::string& path, const std::string& name,
                     std::set<std::string>& seen) {
  const std::string_view driver = gdal().driver_name(gdal().driver_of(dataset.get()));
  require_exact_numbers(dataset, name);
  require_no_gaps_in_bands(dataset, name);
  if (driver != "VRT" || !seen.insert(path).second) return;
  require_whole_mosaic(dataset, path, name);
  const ListHandle files(gdal().files_of(dataset.get()));
  for (char** file = files.get(); file && *file; ++file) {
    if (path == *file || !is_picture_of_its_own(*file)) continue;
    const DatasetHandle part = opened(*file, GDAL_OF_RASTER);
    if (part) require_no_gaps(part, *file, fmt::format("{}: {}", name, *file), seen);
  }
}

void require_no_palette(const DatasetHandle& dataset, const std::string& name) {
  for (int i = 1; i <= gdal().raster_count(dataset.get()); ++i) {
    if (gdal().colour_meaning(gdal().raster_band(dataset.get(), i)) != GCI_PaletteIndex) continue;
    throw InputError(name, {.expected = "numbers",
                            .found = "a picture whose numbers stand for colours",
                            .advice = "if they are heights, say so with `gdal_translate "
                                      "-colorinterp gray in.tif out.tif`"});
  }
}

// The words of an ASCII grid behind its head.
class GridWords {
 public:
  GridWords(const std::string& path, std::uint64_t cells, const std::string& name)
      : cells_(cells), name_(name) {
    const FileHandle file(gdal().open_file(path.c_str(), "rb"));
    std::string part(1 << 20, '\0');
    while (file) {
      part.resize(gdal().read_file(part.data(), 1, part.size(), file.get()));
      if (part.empty()) break;
      for (const char c : part) take(c);
    }
    end_word();
    if (words_ != cells_) refuse(counted(words_, "number"));
  }

 private:
  void take(char c) {
    if (c == ' ' || c == '\t' || c == '\r' || c == '\n') {
      end_word();
    } else {
      word_ += c;
    }
  }

  void end_word() {
    if (word_.empty()) return;
    if (value_of_key_) {
      value_of_key_ = false;
    } else if (words_ == 0 && is_key()) {
      value_of_key_ = true;
    } else {
      if (!is_number()) refuse(in_quotes(word_.substr(0, 40)));
      if (++words_ > cells_) refuse("more");
    }
    word_.clear();
  }

  bool is_key() const {
    constexpr const char* kKeys[] = {"ncols",     "nrows",       "xllcorner", "yllcorner",
                                     "xllcenter", "yllcenter",   "cellsize",  "dx",
                                     "dy",        "nodata_value"};
    return std::any_of(std::begin(kKeys), std::end(kKeys),
                       [&](const char* key) { return EQUAL(word_.c_str(), key); });
  }

  // GDAL takes a comma for a point, and any word that is no number for 0.
  bool is_number() {
    std::replace(word_.begin(), word_.end(), ',', '.');
    return parse_number(word_) || EQUAL(word_.c_str(), "nan") || EQUAL(word_.c_str(), "-nan");
  }

  [[noreturn]] void refuse(const std::string& found) const {
    throw InputError(name_,
                     {.expected = fmt::format("{} behind its head", counted(cells_, "number")),
                      .found = found,
                      .advice = "the file is damaged or cut, get it again"});
  }

  std::uint64_t cells_;
  const std::string& name_;
  std::string word_;
  bool value_of_key_ = false;
  std::uint64_t words_ = 0;
};

}  // namespace

void require_whole_raster(const DatasetHandle& dataset, const std::string& path,
                          const std::string& name) {
  const std::string_view driver = gdal().driver_name(gdal().driver_of(dataset.get()));
  require_whole_format(driver, name);
  require_one_picture(dataset, name);
  std::set<std::string> seen;
  require_no_gaps(dataset, path, name, seen);
  require_no_palette(dataset, name);
  if (driver == "AAIGrid") {
    const auto columns = static_cast<std::uint64_t>(gdal().raster_width(dataset.get()));
    const auto rows = static_cast<std::uint64_t>(gdal().raster_height(dataset.get()));
    GridWords(path, columns * rows, name);
  }
}

void require_no_layers(const DatasetHandle& dataset, const std::string& path) {
  const DatasetHandle layers = opened(path, GDAL_OF_VECTOR);
  if (!layers || gdal().driver_of(layers.get()) != gdal().driver_of(dataset.get()) ||
      gdal().layer_count(layers.get()) == 0) {
    return;
  }
  throw InputError(path, {.expected = "a raster of heights, or polygons",
                          .found = "both in one file",
                          .advice = "read each by itself, with --format raster and with --format "
                                    "vector, and put both maps together with skyway-map join"});
}

}  // namespace geom::gis
