#pragma once

// CityJSON 1.0 to 2.0 (cityjson.org), also as a sequence: solid and surface models of cities.

#include <iosfwd>
#include <string_view>

#include "geom/import/city_model.h"

namespace geom {

// Of each object all geometries, templates in their places; the attributes that tell heights. A
// sequence (CityJSONSeq) has a CityJSON in its first line, with the transform, the reference system
// and the templates of all, and a CityJSONFeature in each line that follows. Parts, parents and
// members that are named and not there are skipped. Throws InputError(source, …) for what is not
// CityJSON of these versions: an index, a vertex or a ring that is wrong names its object.
CityModel read_city_json(std::istream& in, std::string_view source);

}  // namespace geom
