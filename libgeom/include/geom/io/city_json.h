#pragma once

// CityJSON 1.0 to 2.0 (cityjson.org): solid and surface models of cities.

#include <iosfwd>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "geom/footprint.h"

namespace geom {

struct CityJson {
  // In the file's own coordinates. Every surface over its area in plan, from the lowest point of
  // its object up to its own highest; walls as polygons without area. ids count objects from 0.
  std::vector<Footprint> footprints;
  std::string crs;                             // "EPSG:7415", or empty
  std::map<std::string, std::size_t> skipped;  // what was left out, and how often
  std::size_t objects = 0;                     // that gave footprints
};

// Of each object all geometries of its highest level of detail, templates in their places. Roads,
// land use, water and terrain are no obstacles and are skipped. Throws InputError(source, …) for
// what is not CityJSON of these versions: an index, a vertex or a ring that is wrong names its
// object.
CityJson read_city_json(std::istream& in, std::string_view source);

}  // namespace geom
