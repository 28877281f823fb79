#pragma once

// How a flight begins and ends on the ground, and how far from there it may go.
//
// Example:
//   assert(traj::ground_below(scene, {1, 1, 5}) == 0);  // the floor of the bounds
//   const traj::VerticalEnds ends{.takeoff_from = 0, .landing_on = 0};

#include <optional>

#include "geom/collision/collision.h"

namespace traj {

// A vehicle that takes off rises straight to the first point of its path; one that lands sinks
// straight from the last.
struct VerticalEnds {
  std::optional<double> takeoff_from;  // z of the ground, metres
  std::optional<double> landing_on;
};

struct FlightEnvelope {
  double ceiling = 0;    // m above the place of take-off
  double range = 0;      // m from the place of take-off
  double endurance = 0;  // s
};

// The top of the highest obstacle that a vehicle sinking straight from `p` would meet, or the floor
// of the bounds: where it can stand. `p` is free.
double ground_below(const geom::CollisionScene& scene, const geom::Vec3& p);

// The ground of a vehicle that sinks from `p`, if it may be up to `beside` metres
// further along x and y: the height of the highest top that its box without margin may meet, else
// the floor of the bounds; and whether all ground below the box is as high, to `level` metres, so
// that it stands level wherever it comes down. Tops above `p` do not count.
struct LandingGround {
  double height = 0;
  bool whole = true;
};
LandingGround landing_ground(const geom::CollisionScene& scene, const geom::Vec3& p,
                             const geom::Vec3& beside, double level);

}  // namespace traj
