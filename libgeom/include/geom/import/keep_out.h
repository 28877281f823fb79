#pragma once

// No-fly volumes: GeoJSON polygons with a lower and an upper altitude.
//
// Example:
//   std::istringstream in(R"({"type":"Polygon","coordinates":[[[0,0],[9,0],[9,9],[0,9],[0,0]]]})");
//   const geom::KeepOut zones =
//       geom::read_keep_out(in, "zones.geojson", geom::Frame{}, {.local = true, .ceiling = 120});
//   assert(zones.volumes[0].top == 120);

#include <iosfwd>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geom/map/footprint.h"
#include "geom/map/frame.h"
#include "geom/map/time_span.h"

namespace geom {

struct KeepOut {
  std::vector<Footprint> volumes;   // in the map's coordinates; ids count the features from 0
  std::vector<std::string> labels;  // "keep-out: NAME", one a volume
  std::vector<double> bulge;        // metres the true outline may reach outside the polygon
  std::vector<TimeSpan> times;      // when each is there, rounded outward
  // Whether one reaches down to the map's floor, or up to its ceiling, since the file says no
  // altitude: wider bounds of the map would let vehicles through below or above it.
  bool open_below = false;
  bool open_above = false;
  bool longitude_first = false;  // whether the file should have it so, and may have it wrong
  // Names that speak of heights or times and are not read, as ED-318 and others have them, and how
  // many features have each.
  std::map<std::string, std::size_t> unread;
};

struct KeepOutOptions {
  bool local = false;  // coordinates are the map's own metres, not longitude and latitude
  double floor = 0;    // metres: where a volume without lower altitude starts
  double ceiling = 0;  // where one without upper altitude ends
  // The instant that seconds count from, as epoch_from() writes it (geom/text/instant.h).
  std::optional<std::string> epoch;
};

// An edge is straight in longitude and latitude, as GeoJSON has it, and bends in metres: it is cut
// into pieces of 200 m or less (or 1000 pieces), and `bulge` bounds what they leave out.
//
// A FeatureCollection, a Feature or a geometry of Polygons and MultiPolygons. Properties: `lower`
// or `lower_altitude_m`, `upper` or `upper_altitude_m` (metres in the map's z), and `name`. A
// volume is always there unless the property `from` or `until` says otherwise: seconds after the
// epoch, or an instant in UTC (RFC 3339). Both are closed. A member `epoch` of the whole, or of a
// volume with times, names the epoch. Throws InputError(source, …) for malformed JSON, other
// geometries, rings of fewer than 4 positions, altitudes that are no numbers or inverted, times
// that are none or inverted, times without an epoch, another epoch, and without `local` for a frame
// that has no origin; for two names of one altitude that do not agree, and for an altitude beside a
// unit or a reference ("uom", "lowerReference", …), which may be others than the map's.
KeepOut read_keep_out(std::istream& in, std::string_view source, const Frame& frame,
                      const KeepOutOptions& options);

}  // namespace geom
