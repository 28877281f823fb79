#pragma once

// Whether a mosaic shows all that its parts hold (gdal_*.cpp only).

#include <string>

#include "gdal_handles.h"

namespace geom::gis {

// Throws InputError(name, …) for a mosaic (.vrt at `path`) that makes numbers of cells of its parts
// that hold none, whose type of numbers cannot hold those of its parts, and whose cells are larger
// than those of its parts: GDAL leaves out the others. Other files pass.
void require_whole_mosaic(const DatasetHandle& dataset, const std::string& path,
                          const std::string& name);

}  // namespace geom::gis
