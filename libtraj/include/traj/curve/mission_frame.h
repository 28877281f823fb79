#pragma once

// Where on the Earth a map lies, for what counts in latitudes, longitudes and heights.
//
// Example:
//   const traj::MissionFrame frame{.origin = {47.4, 8.5, 455}, .geoid = 48};  // 407 m over the sea
//   assert(frame.sea_level(47.41, 8.52) == 48);

#include <memory>

#include "geom/map/frame.h"
#include "geom/map/geoid_grid.h"

namespace traj {

// How missions and logs are laid over a map.
struct MissionFrame {
  geom::GeodeticOrigin origin;  // of the map, on the ellipsoid
  double geoid = 0;             // m: sea level above the ellipsoid there
  // Whether origin.height says how high z = 0 is. If not, heights above the sea and above the
  // ellipsoid are refused.
  bool height_known = true;
  std::shared_ptr<const geom::GeoidGrid> geoid_grid = {};  // goes before `geoid`

  // Metres of the sea level above the ellipsoid at a place in degrees: the grid's, or `geoid`.
  // Throws geom::InputError where the grid does not know the place.
  double sea_level(double latitude, double longitude) const;

  // Metres that the sea level may be above or below that: 0 for one that the user gives.
  double sea_error() const { return geoid_grid ? geoid_grid->error : 0; }
};

}  // namespace traj
