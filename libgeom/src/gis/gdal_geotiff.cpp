#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "gdal_handles.h"
#include "geom/gis/geotiff.h"
#include "geom/map/geographic_frame.h"

namespace geom::gis {
namespace {

[[noreturn]] void fail(const std::string& path, const char* what) {
  throw std::runtime_error(
      fmt::format("cannot write {}: {} (GDAL: {})", path, what, gdal().last_error()));
}

// Of the map's metres; empty where nobody knows.
std::string crs_of(const Frame& frame) {
  return !frame.crs.empty() || !frame.origin ? frame.crs : plane_about(*frame.origin);
}

void place(const DatasetHandle& file, const NumberGrid& grid, const Frame& frame,
           const std::string& path) {
  double transform[6] = {grid.corner.x(),
                         grid.cell,
                         0,
                         grid.corner.y() + grid.cell * static_cast<double>(grid.rows),
                         0,
                         -grid.cell};
  gdal().set_geo_transform(file.get(), transform);
  const std::string crs = crs_of(frame);
  if (crs.empty()) return;
  const ReferenceHandle reference = reference_to_write(crs, path);
  if (gdal().set_spatial_reference(file.get(), reference.get()) != CE_None) {
    fail(path, "it takes no reference system");
  }
}

void write_band(const DatasetHandle& file, const NumberGrid& grid, std::size_t index,
                const std::string& path) {
  const NumberBand& band = grid.bands[index];
  const GDALRasterBandH handle = gdal().raster_band(file.get(), static_cast<int>(index + 1));
  gdal().set_description(handle, band.name.c_str());
  gdal().set_metadata_item(handle, "DESCRIPTION", band.what.c_str(), nullptr);
  gdal().set_no_data(handle, std::numeric_limits<double>::quiet_NaN());
  std::vector<double> values = band.values;  // GDAL takes no constant
  const int columns = static_cast<int>(grid.columns);
  const int rows = static_cast<int>(grid.rows);
  if (gdal().raster_io(handle, GF_Write, 0, 0, columns, rows, values.data(), columns, rows,
                       GDT_Float64, 0, 0) != CE_None) {
    fail(path, "it takes no numbers");
  }
}

void read_back(const std::string& path, const NumberGrid& grid) {
  const DatasetHandle file(
      gdal().open(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, nullptr, nullptr, nullptr));
  const int columns = static_cast<int>(grid.columns);
  const int rows = static_cast<int>(grid.rows);
  for (std::size_t i = 0; file && i < grid.bands.size(); ++i) {
    const std::vector<double>& wrote = grid.bands[i].values;
    std::vector<double> read(wrote.size());
    const bool done =
        gdal().raster_io(gdal().raster_band(file.get(), static_cast<int>(i + 1)), GF_Read, 0, 0,
                         columns, rows, read.data(), columns, rows, GDT_Float64, 0, 0) == CE_None;
    for (std::size_t k = 0; k < read.size(); ++k) {
      const bool same = read[k] == wrote[k] || (std::isnan(read[k]) && std::isnan(wrote[k]));
      if (!done || !same) fail(path, "it does not read back as it was written");
    }
  }
  if (!file) fail(path, "it cannot be read back");
}

}  // namespace

void write_geotiff(const std::string& path, const NumberGrid& grid, const Frame& frame) {
  {
    char compress[] = "COMPRESS=DEFLATE";
    char tiled[] = "TILED=YES";
    char* options[] = {compress, tiled, nullptr};
    const DatasetHandle file(gdal().create(
        gdal().driver_named("GTiff"), path.c_str(), static_cast<int>(grid.columns),
        static_cast<int>(grid.rows), static_cast<int>(grid.bands.size()), GDT_Float64, options));
    if (!file) fail(path, "it cannot be made");
    place(file, grid, frame, path);
    for (std::size_t i = 0; i < grid.bands.size(); ++i) write_band(file, grid, i, path);
  }
  read_back(path, grid);
}

}  // namespace geom::gis
