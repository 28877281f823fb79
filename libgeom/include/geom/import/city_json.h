#pragma once

// CityJSON 1.0 to 2.0 (cityjson.org): solid and surface models of cities.

#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "geom/import/skipped.h"
#include "geom/map/footprint.h"

namespace geom {

struct CityJson {
  // In the file's own coordinates. Every surface over its area in plan, from the lowest point of
  // its object up to its own highest; walls as polygons without area. ids count objects from 0.
  std::vector<Footprint> footprints;
  std::string crs;          // "EPSG:7415", or empty
  Skipped skipped;          // objects without a shape of surfaces
  std::size_t objects = 0;  // that gave footprints
};

// Of each object all geometries of its highest level of detail, templates in their places, whatever
// its type: a road may lead over a bridge. Terrain, land use and water are ground, which is solid
// below. An object without geometry is its children; one that has neither is skipped. Throws
// InputError(source, …) for what is not CityJSON of these versions: an index, a vertex or a ring
// that is wrong names its object.
CityJson read_city_json(std::istream& in, std::string_view source);

}  // namespace geom
