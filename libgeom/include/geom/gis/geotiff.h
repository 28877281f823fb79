#pragma once

// GeoTIFFs of numbers on a grid of a map, for QGIS and other programs.
//
// Example, not run:
//   geom::gis::NumberGrid grid{.columns = 2, .rows = 1, .cell = 5};
//   grid.bands = {{"distance", "m to the nearest obstacle", {3.5, 4}}};
//   geom::gis::write_geotiff("clearance.tif", grid, map.spec().frame);

#include <string>

#include "geom/gis/number_grid.h"
#include "geom/map/frame.h"

namespace geom::gis {

// The CRS is the frame's where it names one, else a transverse Mercator projection about its
// origin, in which the map's metres are (GeographicFrame); without an origin none. East and north
// are the raster's axes, whatever those of the map are. The file is read back, and every number is
// what was written. It must not be there yet. GDAL is loaded for it. Throws std::runtime_error
// where GDAL is not installed, or cannot write; InputError for a CRS that PROJ does not know.
void write_geotiff(const std::string& path, const NumberGrid& grid, const Frame& frame);

}  // namespace geom::gis
