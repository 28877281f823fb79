#include "gdal_whole_raster.h"

#include <algorithm>
#include <iterator>
#include <string_view>

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

// Where no part of a mosaic is, GDAL gives the value for none, or else 0.
void require_no_gaps(const DatasetHandle& dataset, std::string_view driver,
                     const std::string& name) {
  const auto refuse = [&](const char* found, const char* advice) {
    throw InputError(name, {.expected = "a value that stands for no number",
                            .found = fmt::format("none, in {}: gaps would count as 0", found),
                            .advice = advice});
  };
  for (int i = 1; i <= gdal().raster_count(dataset.get()); ++i) {
    const GDALRasterBandH band = gdal().raster_band(dataset.get(), i);
    if (gdal().mask_flags(band) != GMF_ALL_VALID) continue;
    if (driver == "GPKG") {
      refuse("a GeoPackage, which may lack tiles",
             "if it has all of them, write it as GeoTIFF with `gdal_translate`");
    }
    if (driver != "VRT") continue;
    const int covered = gdal().coverage(band, 0, 0, gdal().raster_width(dataset.get()),
                                        gdal().raster_height(dataset.get()), 0, nullptr);
    if (covered & GDAL_DATA_COVERAGE_STATUS_EMPTY) {
      refuse("a mosaic with gaps", "make it anew with `gdalbuildvrt -vrtnodata -9999`");
    }
  }
}

}  // namespace

void require_whole_raster(const DatasetHandle& dataset, const std::string& name) {
  const std::string_view driver = gdal().driver_name(gdal().driver_of(dataset.get()));
  require_whole_format(driver, name);
  require_one_picture(dataset, name);
  require_no_gaps(dataset, driver, name);
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
