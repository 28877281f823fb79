#pragma once

// Columns of numbers that hold something else: GDAL reads "12,5" as 12 there, and says nothing
// (gdal_*.cpp only).

#include <string>

#include "gdal_handles.h"

namespace geom::gis {

// Throws InputError(name, …) where a shapefile, a GeoPackage or an SQLite database has, in a column
// of numbers that tell heights or storeys, what is no number. `attribute` is such a column, too.
void require_whole_numbers(const DatasetHandle& dataset, const std::string& attribute,
                           const std::string& name);

}  // namespace geom::gis
