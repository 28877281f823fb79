#include "gdal_cells.h"

#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

namespace geom::gis {
namespace {

bool is_opacity(GDALRasterBandH band) { return gdal().colour_meaning(band) == GCI_AlphaBand; }

// Esri's ASCII grids have one of their own where they name none.
std::optional<double> value_for_none(const DatasetHandle& dataset, GDALRasterBandH band) {
  int given = 0;
  const double none = gdal().no_data(band, &given);
  if (!given) {
    const std::string_view driver = gdal().driver_name(gdal().driver_of(dataset.get()));
    return driver == "AAIGrid" ? std::optional(-9999.0) : std::nullopt;
  }
  return gdal().data_type(band) == GDT_Float32 ? static_cast<float>(none) : none;
}

bool exists(const std::string& path) {
  VSIStatBufL found;
  return gdal().stat(path.c_str(), &found) == 0;
}

}  // namespace

int number_bands(const DatasetHandle& dataset) {
  int count = 0;
  for (int i = 1; i <= gdal().raster_count(dataset.get()); ++i) {
    count += !is_opacity(gdal().raster_band(dataset.get(), i));
  }
  return count;
}

RasterCells::RasterCells(const DatasetHandle& dataset, const std::string& path,
                         const std::string& name) {
  for (int i = 1; i <= gdal().raster_count(dataset.get()); ++i) {
    const GDALRasterBandH band = gdal().raster_band(dataset.get(), i);
    if (!is_opacity(band)) {
      band_ = band;
    } else {
      opacity_ = {band, gdal().data_type(band) == GDT_UInt16 ? 65535.0 : 255.0};
    }
  }
  none_ = value_for_none(dataset, band_);
  scale_ = gdal().raster_scale(band_, nullptr);
  offset_ = gdal().raster_offset(band_, nullptr);
  if (!(std::isfinite(scale_) && scale_ != 0 && std::isfinite(offset_))) {
    throw InputError(name, {.expected = "a finite scale that is not 0, and a finite offset",
                            .found = fmt::format("{} and {}", scale_, offset_),
                            .advice = "take them away with `gdal_translate -a_scale 1 -a_offset 0` "
                                      "if its numbers are what they say"});
  }
  // GDAL makes a mask of a value for none, too, which is compared here.
  const int flags = gdal().mask_flags(band_);
  if (flags != GMF_ALL_VALID && flags != GMF_NODATA && !(flags & GMF_ALPHA)) {
    mask_ = {gdal().mask_of(band_)};
  } else if (exists(path + ".msk")) {
    throw InputError(name, {.expected = "a mask beside it that GDAL can read",
                            .found = fmt::format("{}.msk, which it passes over", name),
                            .advice = "make it again with `gdal_translate -mask`, or take it away "
                                      "if all cells count"});
  }
}

bool RasterCells::read(int column, int row, int columns, int rows, double* out) const {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const auto numbers_of = [&](GDALRasterBandH band, double* to) {
    return gdal().raster_io(band, GF_Read, column, row, columns, rows, to, columns, rows,
                            GDT_Float64, 0, 0) == CE_None;
  };
  if (!numbers_of(band_, out)) return false;
  const std::size_t count = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  for (std::size_t i = 0; i < count; ++i) {
    out[i] = none_ && out[i] == *none_ ? kNone : out[i] * scale_ + offset_;
  }
  for (const Mask& mask : {mask_, opacity_}) {
    if (!mask.band) continue;
    std::vector<double> values(count);
    if (!numbers_of(mask.band, values.data())) return false;
    for (std::size_t i = 0; i < count; ++i) {
      if (values[i] != mask.known) out[i] = kNone;
    }
  }
  return true;
}

}  // namespace geom::gis
