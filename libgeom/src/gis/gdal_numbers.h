#pragma once

// Columns of numbers that hold something else: GDAL reads "12,5" as 12 there, and 12.5 as 12 in one
// of whole numbers, and says nothing (gdal_*.cpp only).

#include <string>

#include "gdal_handles.h"

namespace geom::gis {

// Throws InputError(name, …) where a shapefile, a GeoPackage, an SQLite database, Esri JSON or KML
// has, in a column of numbers that tell heights or storeys, what is no number, or no whole one in a
// column of these. Throws it where the .csvt of a CSV makes such a column one of numbers.
// `attribute` is such a column, too. The dataset was opened from `path`.
void require_whole_numbers(const DatasetHandle& dataset, const std::string& path,
                           const std::string& attribute, const std::string& name);

}  // namespace geom::gis
