#pragma once

// Rally points from GeoJSON: places in the air to which an autopilot may return.
//
// Example:
//   std::istringstream in(R"({"type":"Point","coordinates":[8.501,47.401,440]})");
//   const geom::Frame frame{.origin = geom::GeodeticOrigin{47.4, 8.5, 400}};
//   const auto rally = traj::read_rally(in, "rally.geojson", frame);
//   assert(rally.size() == 1 && std::abs(rally[0].z() - 40) < 1e-9);

#include <iosfwd>
#include <string_view>
#include <vector>

#include "geom/base/vec3.h"
#include "geom/map/frame.h"

namespace traj {

// Points of a FeatureCollection, a Feature or a geometry, in the axes of the map. Each has three
// coordinates: longitude, latitude, and metres above the ellipsoid, as the frame's origin counts
// them. Throws geom::InputError(source, …) for malformed JSON, other geometries, points without a
// height, places that are not near the origin, a file without points and a frame without an origin.
std::vector<geom::Vec3> read_rally(std::istream& in, std::string_view source,
                                   const geom::Frame& frame);

}  // namespace traj
