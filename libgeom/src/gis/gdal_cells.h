#pragma once

// The numbers of a raster, and which of its cells have none (gdal_*.cpp only).

#include <optional>
#include <string>

#include "gdal_handles.h"

namespace geom::gis {

// Bands of a raster other than those that say how transparent its cells are.
int number_bands(const DatasetHandle& dataset);

// A raster of one band of numbers. A cell has no number where it holds the value for none or NaN,
// where the mask of the file excludes it, and where it is not wholly opaque.
class RasterCells {
 public:
  // `path` is what the dataset was opened from. Throws InputError(name, …) for a scale of 0, by
  // which all numbers would be one, and for a mask beside the file that GDAL passes over. The
  // dataset must outlive this.
  RasterCells(const DatasetHandle& dataset, const std::string& path, const std::string& name);

  // Numbers after scale and offset of the band, row by row; NaN where there are none. False where
  // GDAL cannot read them.
  bool read(int column, int row, int columns, int rows, double* out) const;

  GDALRasterBandH band() const { return band_; }

 private:
  struct Mask {
    GDALRasterBandH band = nullptr;
    double known = 255;  // its value where a cell counts
  };

  GDALRasterBandH band_ = nullptr;
  Mask mask_;     // without a band where the file has none
  Mask opacity_;  // the same
  std::optional<double> none_;
  double scale_ = 1;
  double offset_ = 0;
};

}  // namespace geom::gis
