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

// A velocity, m/s. If the vehicle began at rest, or is to rest, at a place of the leg, it is slower
// near that place than this.
struct Velocity {
  Vec3 value = Vec3::Zero();
  std::optional<Vec3> since = {};  // the place where it rested before
  std::optional<Vec3> until = {};  // the place where it will rest
};

// How a vehicle may move in a region: any velocity in the convex hull of these and 0, on these legs
// of its way.
struct Motion {
  std::size_t first_leg = 0;
  std::size_t last_leg = 0;
  std::vector<Velocity> velocity = {};
};

// The convex hull of a few points, metres.
struct Sweep {
  std::vector<Vec3> hull;
  FlightPart part;
  // Of a way up from the ground or down to it: the ground's z. What lies below that is stood on, so
  // it is not in the way.
  std::optional<double> stands_on = {};
  std::optional<Motion> motion = {};
};

// A straight leg and when it is flown, s after the flight begins.
struct TimedLeg {
  Vec3 a;
  Vec3 b;
  double from = 0;
  double until = 0;
  FlightPart part = {};
};

// Where one autopilot may be while it flies a mission: anywhere in the sweeps, and within `around`
// of them along each axis.
struct Drift {
  std::string autopilot;  // as reports name it
  std::vector<Sweep> sweeps;
  Vec3 around = Vec3::Zero();  // m
  std::vector<TimedLeg> legs =
      {};            // of its way, from the ground to the ground; times are estimates
  double speed = 0;  // m/s: the fastest of these
};

}  // namespace traj
