#pragma once

// A way as a line for maps: KML and GeoJSON.

#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "geom/geographic_frame.h"

namespace traj {

struct GeoLine {
  std::string name;
  std::string note;  // may be empty
  std::vector<geom::GeodeticPlace> points;
};

// KML 2.2: one Placemark with a LineString, longitude, latitude, height above sea level
// ("absolute"): degrees to 1e-9, metres to a tenth of a millimetre. Heights of `line` are those it
// writes.
void write_kml(std::ostream& out, const GeoLine& line);

// RFC 7946: a FeatureCollection of one LineString; heights are above the ellipsoid. As exact.
void write_geojson(std::ostream& out, const GeoLine& line);

// The points of the first LineString. Throw geom::InputError(source, …) where there is none, or
// coordinates that are not three finite numbers.
std::vector<geom::GeodeticPlace> read_kml(std::istream& in, std::string_view source);
std::vector<geom::GeodeticPlace> read_geojson(std::istream& in, std::string_view source);

}  // namespace traj
