#pragma once

// Where on the Earth a map lies, for what counts in latitudes, longitudes and heights.
//
// Example:
//   const traj::MissionFrame frame{.origin = {47.4, 8.5, 455}, .geoid = 48};  // 407 m over the sea

#include "geom/map/frame.h"

namespace traj {

// How missions and logs are laid over a map.
struct MissionFrame {
  geom::GeodeticOrigin origin;  // of the map, on the ellipsoid
  double geoid = 0;             // m: sea level above the ellipsoid there
  // Whether origin.height says how high z = 0 is. If not, heights above the sea and above the
  // ellipsoid are refused.
  bool height_known = true;
};

}  // namespace traj
