#pragma once

// A way as a line for maps: KML and GeoJSON.
//
// Example:
//   std::stringstream file;
//   traj::write_geojson(file, {.name = "q1", .points = {{47.4, 8.5, 400}, {47.4, 8.501, 420}}});
//   assert(traj::read_geojson(file, "way.geojson")[0].size() == 2);

#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "geom/map/geographic_frame.h"

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

using GeoPoints = std::vector<geom::GeodeticPlace>;

// The points of every line in the file, in order; at least one line, and in each at least one
// point. KML: LineStrings, wherever they stand. GeoJSON: LineStrings and MultiLineStrings, in
// features, collections and alone. Throw geom::InputError(source, line, …) for whatever else has a
// place (a Point, a Polygon, a track, an overlay, a link to another file), elements of KML that are
// not known, coordinates that are not three numbers, heights that are not absolute (in KML that
// must be said: unsaid means on the ground), and a coordinate system other than WGS 84 longitude,
// latitude.
std::vector<GeoPoints> read_kml(std::istream& in, std::string_view source);
std::vector<GeoPoints> read_geojson(std::istream& in, std::string_view source);

}  // namespace traj
