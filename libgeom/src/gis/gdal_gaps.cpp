#include "gdal_gaps.h"

#include <algorithm>
#include <limits>
#include <string_view>
#include <vector>

namespace geom::gis {
namespace {

constexpr const char* kBrokenTiff =
    "its writing or copying may have broken off: get it again; if its numbers are 0 there, write "
    "it whole with `gdal_translate`";

[[noreturn]] void refuse_gaps(const std::string& name, std::string_view found, const char* advice) {
  throw InputError(name, {.expected = "a value that stands for no number",
                          .found = fmt::format("none, in {}: gaps would count as 0", found),
                          .advice = advice});
}

// Columns and rows of a band.
struct Window {
  int column;
  int row;
  int columns;
  int rows;
};

// What GDAL can tell of a part: whether there are numbers, and whether there are none.
int coverage_of(GDALRasterBandH band, const Window& w) {
  return gdal().coverage(band, w.column, w.row, w.columns, w.rows, 0, nullptr);
}

// What cannot be read is refused where heights are taken.
std::vector<double> numbers_of(GDALRasterBandH band, const Window& w) {
  std::vector<double> out(static_cast<std::size_t>(w.columns) * static_cast<std::size_t>(w.rows));
  if (gdal().raster_io(band, GF_Read, w.column, w.row, w.columns, w.rows, out.data(), w.columns,
                       w.rows, GDT_Float64, 0, 0) != CE_None) {
    std::fill(out.begin(), out.end(), std::numeric_limits<double>::quiet_NaN());
  }
  return out;
}

// Calls f for each part in which the file keeps the band.
template <class F>
void for_each_block(const DatasetHandle& dataset, GDALRasterBandH band, const F& f) {
  const int width = gdal().raster_width(dataset.get());
  const int height = gdal().raster_height(dataset.get());
  int columns = 0;
  int rows = 0;
  gdal().block_size(band, &columns, &rows);
  for (int row = 0; row < height; row += rows) {
    for (int column = 0; column < width; column += columns) {
      f(Window{column, row, std::min(columns, width - column), std::min(rows, height - row)});
    }
  }
}

// Where numbers are missing, a mask or a band of opacity must say so.
void require_masked_gaps(const DatasetHandle& dataset, GDALRasterBandH band, GDALRasterBandH mask,
                         const std::string& name) {
  const std::string_view driver = gdal().driver_name(gdal().driver_of(dataset.get()));
  for_each_block(dataset, band, [&](const Window& w) {
    if (!(coverage_of(band, w) & GDAL_DATA_COVERAGE_STATUS_EMPTY)) return;
    const std::vector<double> numbers = numbers_of(band, w);
    const std::vector<double> known = numbers_of(mask, w);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (numbers[i] != 0 || known[i] == 0) continue;
      if (driver == "VRT") {
        refuse_gaps(name, "a mosaic with gaps that its mask does not exclude",
                    "make it anew with `gdalbuildvrt -vrtnodata -9999`");
      }
      refuse_gaps(name, "a TIFF without some of its parts, which its mask does not exclude",
                  kBrokenTiff);
    }
  });
}

// GDAL does not tell which parts of an Erdas image were never written.
void require_no_part_of_zeros(const DatasetHandle& dataset, GDALRasterBandH band,
                              const std::string& name) {
  for_each_block(dataset, band, [&](const Window& w) {
    const std::vector<double> numbers = numbers_of(band, w);
    if (std::any_of(numbers.begin(), numbers.end(), [](double v) { return v != 0; })) return;
    refuse_gaps(name, "an Erdas image with a part of 0 alone, which may never have been written",
                "if its numbers are 0 there, write it as GeoTIFF with `gdal_translate`; if they "
                "stand for none, with `gdal_translate -a_nodata 0`");
  });
}

bool is_opacity(GDALRasterBandH band) { return gdal().colour_meaning(band) == GCI_AlphaBand; }

// Of mosaics that warp, GDAL does not say that their band of opacity is a mask.
GDALRasterBandH opacity_of(const DatasetHandle& dataset) {
  for (int i = gdal().raster_count(dataset.get()); i > 0; --i) {
    const GDALRasterBandH band = gdal().raster_band(dataset.get(), i);
    if (is_opacity(band)) return band;
  }
  return nullptr;
}

}  // namespace

// Where a part of a file or of a mosaic is missing, GDAL gives the value for none, or else 0.
void require_no_gaps_in_bands(const DatasetHandle& dataset, const std::string& name) {
  const std::string_view driver = gdal().driver_name(gdal().driver_of(dataset.get()));
  const Window all{0, 0, gdal().raster_width(dataset.get()), gdal().raster_height(dataset.get())};
  for (int i = 1; i <= gdal().raster_count(dataset.get()); ++i) {
    const GDALRasterBandH band = gdal().raster_band(dataset.get(), i);
    const int covered = coverage_of(band, all);
    const int flags = gdal().mask_flags(band);
    if (flags & GMF_NODATA || is_opacity(band)) continue;
    const GDALRasterBandH opacity = opacity_of(dataset);
    if (opacity || flags != GMF_ALL_VALID) {
      if (covered & GDAL_DATA_COVERAGE_STATUS_EMPTY) {
        require_masked_gaps(dataset, band, opacity ? opacity : gdal().mask_of(band), name);
      }
      continue;
    }
    if (driver == "HFA") require_no_part_of_zeros(dataset, band, name);
    if (driver == "GPKG") {
      refuse_gaps(name, "a GeoPackage, which may lack tiles",
                  "if it has all of them, write it as GeoTIFF with `gdal_translate`");
    }
    if (driver == "VRT" && (covered & GDAL_DATA_COVERAGE_STATUS_UNIMPLEMENTED)) {
      refuse_gaps(name, "a mosaic that is turned or warped",
                  "make it anew with `gdalwarp -dstnodata -9999`");
    }
    if (driver == "VRT" && (covered & GDAL_DATA_COVERAGE_STATUS_EMPTY)) {
      refuse_gaps(name, "a mosaic with gaps", "make it anew with `gdalbuildvrt -vrtnodata -9999`");
    }
    if (driver == "GTiff" && (covered & GDAL_DATA_COVERAGE_STATUS_EMPTY)) {
      refuse_gaps(name, "a TIFF without some of its parts", kBrokenTiff);
    }
  }
}

}  // namespace geom::gis
