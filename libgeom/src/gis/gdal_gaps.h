#pragma once

// Parts of a raster that its file does not hold, which GDAL fills with 0 (gdal_*.cpp only).

#include <string>

#include "gdal_handles.h"

namespace geom::gis {

// Throws InputError(name, …) where a band has or may have such parts, and neither a value for none
// nor a mask says that they hold no numbers.
void require_no_gaps_in_bands(const DatasetHandle& dataset, const std::string& name);

}  // namespace geom::gis
