#pragma once

// Rasters that GDAL reads in part, or whose gaps it fills with 0, and says nothing of it
// (gdal_*.cpp only).

#include <string>

#include "gdal_handles.h"

namespace geom::gis {

// Throws InputError(name, …) for a raster of a format that is not known to keep its numbers and its
// holes, as a picture or a table of points; for a file of several pictures, of which GDAL reads the
// first; for a mosaic (a .vrt, a GeoPackage) or a TIFF of which parts are or may be missing, and
// that has no value for none: GDAL gives 0 there (gdal_gaps.h); for a mosaic that names such a
// file, or that loses holes or heights of its parts (gdal_mosaic.h); for colours of a palette; for
// numbers that JPEG compressed; and for an ASCII grid that holds other words than the numbers that
// its head counts. The dataset was opened from `path`, and has a band.
void require_whole_raster(const DatasetHandle& dataset, const std::string& path,
                          const std::string& name);

// Throws InputError(path, …) where the file at `path`, which `dataset` was opened from, has layers
// of features beside its raster.
void require_no_layers(const DatasetHandle& dataset, const std::string& path);

}  // namespace geom::gis
