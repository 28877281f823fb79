#pragma once

// Regions that a vehicle may fly through anywhere: what it makes of a corner, a circle, a spline.
//
// Example:
//   const traj::Sweep corner{.hull = {{1, 1, 1}, {2, 1, 1}, {1, 2, 1}}};
//   const traj::Drift drift{"px4:1.11-1.17", {corner}, {0.3, 0.3, 0.2}};

#include <optional>
#include <string>
#include <vector>

#include "traj/curve/trajectory.h"
#include "traj/proof/flight_part.h"

namespace traj {

// The convex hull of a few points, metres.
struct Sweep {
  std::vector<Vec3> hull;
  FlightPart part;
  // Of a way up from the ground or down to it: the ground's z. What lies below that is stood on, so
  // it is not in the way.
  std::optional<double> stands_on = {};
};

// Where one autopilot may be while it flies a mission: anywhere in the sweeps, and within `around`
// of them along each axis.
struct Drift {
  std::string autopilot;  // as reports name it
  std::vector<Sweep> sweeps;
  Vec3 around = Vec3::Zero();  // m
};

}  // namespace traj
