#include "gdal_mosaic.h"

#include <cmath>
#include <string_view>

#include "gdal_content.h"
#include "vrt_sources.h"

namespace geom::gis {
namespace {

bool is_float(GDALDataType type) { return type == GDT_Float32 || type == GDT_Float64; }

// Whether each height that one type of numbers holds is held by the other.
bool holds(GDALDataType wide, GDALDataType narrow) {
  if (wide == narrow || is_float(wide)) return true;
  if (narrow == GDT_Byte) return true;
  if (narrow == GDT_UInt16) return wide == GDT_UInt32 || wide == GDT_Int32;
  return narrow == GDT_Int16 && wide == GDT_Int32;
}

std::string path_of(const VrtSource& source, const std::string& mosaic) {
  const std::size_t slash = mosaic.find_last_of("/\\");
  if (!source.beside || slash == mosaic.npos) return source.file;
  return mosaic.substr(0, slash + 1) + source.file;
}

bool same(double one, double other) {
  if (one == other) return true;
  if (std::isnan(one) || std::isnan(other)) return std::isnan(one) && std::isnan(other);
  return std::abs(one - other) <= 1e-7 * std::abs(one);  // as text and in single precision
}

// Whether cells of the part that hold no number hold none in the mosaic.
bool keeps_holes(GDALRasterBandH of, GDALRasterBandH part, const VrtSource& source, bool opacity) {
  const int flags = gdal().mask_flags(part);
  if (flags == GMF_ALL_VALID) return true;
  const int shown = gdal().mask_flags(of);
  if (shown == GMF_ALL_VALID) return opacity;
  if (!(shown & GMF_NODATA)) return true;
  if (!(flags & GMF_NODATA)) return source.obeys_mask;
  const double none = gdal().no_data(part, nullptr);
  return same(gdal().no_data(of, nullptr), none) || (source.none && same(*source.none, none));
}

// Whether each cell of the part becomes one of the mosaic, or more.
bool keeps_cells(const VrtSource& source) {
  constexpr double kHalf = 0.5;  // cells, by which sizes may differ by rounding
  if (!source.from || !source.to) return true;
  return source.from->width - source.to->width < kHalf &&
         source.from->height - source.to->height < kHalf;
}

bool has_opacity(const DatasetHandle& dataset) {
  for (int i = 1; i <= gdal().raster_count(dataset.get()); ++i) {
    if (gdal().colour_meaning(gdal().raster_band(dataset.get(), i)) == GCI_AlphaBand) return true;
  }
  return false;
}

}  // namespace

void require_whole_mosaic(const DatasetHandle& dataset, const std::string& path,
                          const std::string& name) {
  if (std::string_view(gdal().driver_name(gdal().driver_of(dataset.get()))) != "VRT") return;
  for (const VrtSource& source : vrt_sources(content_of(path, name), name)) {
    const DatasetHandle file = opened(path_of(source, path), GDAL_OF_RASTER);
    if (!file) continue;  // GDAL cannot read the mosaic there, either
    const GDALRasterBandH of = gdal().raster_band(dataset.get(), source.band_of_mosaic);
    const GDALRasterBandH part = gdal().raster_band(file.get(), source.band);
    if (!of || !part || gdal().colour_meaning(of) == GCI_AlphaBand) continue;
    const auto refuse = [&](const char* expected, const char* found, const char* advice) {
      throw InputError(name, {.item = source.file.substr(0, 80),
                              .expected = expected,
                              .found = found,
                              .advice = advice});
    };
    if (!keeps_holes(of, part, source, has_opacity(dataset))) {
      refuse("a mosaic in which cells without a number have none", "one that gives them numbers",
             "make it anew with `gdalbuildvrt -vrtnodata -9999`");
    }
    if (!holds(gdal().data_type(of), gdal().data_type(part))) {
      refuse("a mosaic whose type of numbers holds those of its parts", "a narrower one",
             "make it anew with `gdalbuildvrt`");
    }
    if (!keeps_cells(source)) {
      refuse("a mosaic with cells no larger than those of its parts",
             "larger ones, of which GDAL leaves out what stands between",
             "make it anew with `gdalbuildvrt -resolution highest`, or let the highest height of "
             "each cell count with `gdalwarp -r max`");
    }
  }
}

}  // namespace geom::gis
