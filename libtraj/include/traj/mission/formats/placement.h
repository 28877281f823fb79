#pragma once

// Where a drone file's coordinates count from, if the file does not say it.
//
// Example:
//   traj::Placement placement;
//   placement.origin = geom::GeodeticOrigin{47.4, 8.5, 400};
//   const traj::MissionFrame frame = placement.mission_frame(map.spec().frame);
//   assert(frame.origin.height == 400);

#include <memory>
#include <optional>
#include <string>

#include "geom/map/frame.h"
#include "geom/shape/polyline.h"
#include "traj/curve/mission_frame.h"

namespace traj {

struct Placement {
  std::optional<geom::GeodeticOrigin> origin;  // of the map's (0, 0, 0); default: the map's own
  double geoid = 0;                            // m: sea level above the ellipsoid there
  // The same place by place; copies share it. Goes before `geoid`.
  std::shared_ptr<const geom::GeoidGrid> geoid_grid = {};
  std::string geoid_name = {};    // its file's, for records
  std::optional<double> ground;   // m in the map's z, at the take-off
  double takeoff_height = 1;      // m above the ground to which a Tello rises
  std::optional<double> heading;  // of a Tello, degrees clockwise from north

  // Its height is known where `origin` gives it, or the frame (geom::knows_height). Throws
  // geom::UsageError where neither this nor the frame knows the origin.
  MissionFrame mission_frame(const geom::Frame& frame) const;
};

// Throws geom::InputError(id, …) for a point (east, north, up) that is further than 200 km from the
// origin: coordinates of a projection, taken as metres from a place, would put home elsewhere.
void require_near_origin(const geom::Polyline& enu, const geom::GeodeticOrigin& origin,
                         const std::string& id);

}  // namespace traj
