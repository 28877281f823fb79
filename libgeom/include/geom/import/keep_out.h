#pragma once

// No-fly volumes: GeoJSON polygons with a lower and an upper altitude.

#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "geom/map/footprint.h"
#include "geom/map/frame.h"

namespace geom {

struct KeepOut {
  std::vector<Footprint> volumes;   // in the map's coordinates; ids count the features from 0
  std::vector<std::string> labels;  // "keep-out: NAME", one a volume
  std::vector<double> bulge;        // metres the true outline may reach outside the polygon
};

struct KeepOutOptions {
  bool local = false;  // coordinates are the map's own metres, not longitude and latitude
  double floor = 0;    // metres: where a volume without lower altitude starts
  double ceiling = 0;  // where one without upper altitude ends
};

// An edge is straight in longitude and latitude, as GeoJSON has it, and bends in metres: it is cut
// into pieces of 200 m or less (or 1000 pieces), and `bulge` bounds what they leave out.
//
// A FeatureCollection, a Feature or a geometry of Polygons and MultiPolygons. Properties: `lower`
// or `lower_altitude_m`, `upper` or `upper_altitude_m` (metres in the map's z), and `name`.
// Throws InputError(source, …) for malformed JSON, other geometries, rings of fewer than 4
// positions, altitudes that are no numbers or inverted, and without `local` for a frame that has no
// origin.
KeepOut read_keep_out(std::istream& in, std::string_view source, const Frame& frame,
                      const KeepOutOptions& options);

}  // namespace geom
