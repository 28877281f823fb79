#pragma once

// Whether a mosaic shows all that its parts hold (gdal_*.cpp only).

#include <string>

#include "gdal_handles.h"

namespace geom::gis {

// Throws InputError(name, …) for a mosaic (.vrt at `path`) that shows less than its parts hold: it
// fills their holes with numbers, its type of numbers is narrower, or its cells are larger, so that
// GDAL leaves some out. Other files pass.
void require_whole_mosaic(const DatasetHandle& dataset, const std::string& path,
                          const std::string& name);

}  // namespace geom::gis
