#pragma once

// CityJSON 1.0 to 2.0 (cityjson.org), also as a sequence: solid and surface models of cities.

#include <iosfwd>
#include <string_view>

#include "geom/import/city_model.h"

namespace geom {

// Reads all geometries of each object, with templates placed, and the attributes of heights. A
// sequence (CityJSONSeq) has a CityJSON in its first line, with the transform, the reference system
// and the templates of all, and a CityJSONFeature in each line that follows. Parts, parents and
// members that are named and not there are skipped. Throws InputError(source, …) if the text is not
// CityJSON of these versions; for a wrong index, vertex or ring it names the object.
CityModel read_city_json(std::istream& in, std::string_view source);

}  // namespace geom
