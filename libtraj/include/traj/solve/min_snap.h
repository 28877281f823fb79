#pragma once

// The trajectory of least snap through waypoints at given times.
//
// Example:
//   const std::vector<geom::Vec3> points = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}};
//   const traj::Trajectory curve = traj::min_snap(points, std::vector<double>{2, 2});
//   assert((traj::evaluate(curve, 2).position - points[1]).norm() < 1e-12);

#include <optional>
#include <span>
#include <vector>

#include "traj/curve/trajectory.h"

namespace traj {

// A place to pass and what is fixed there. A derivative that is absent is chosen for the least
// snap; at the first and the last waypoint, and where there is a hold, it is zero.
struct Waypoint {
  Vec3 position = Vec3::Zero();
  std::optional<Vec3> velocity;      // m/s
  std::optional<Vec3> acceleration;  // m/s2
  std::optional<Vec3> jerk;          // m/s3
  double hold = 0;                   // seconds standing still here, >= 0; > 0 makes it a stop
};

std::vector<Waypoint> waypoints_at(std::span<const Vec3> points);  // with nothing fixed

// The same with repeated points as one. A leg of no length adds its time (seconds, one fewer than
// waypoints) to the hold there, holds add up, and of each derivative the first that is given stays.
// A waypoint with a hold is a stop, and keeps no derivative.
struct Legs {
  std::vector<Waypoint> waypoints;
  std::vector<double> times;
};
Legs without_repeats(std::span<const Waypoint> waypoints, std::span<const double> times);

// Minimises the integral of |fourth derivative|^2 over all curves that pass the waypoints after the
// given leg times (seconds, > 0 for legs of positive length; one fewer than waypoints). A hold is
// one constant segment; repeated points are taken as without_repeats says. When every waypoint is
// the same and nothing holds, the result rests for 1 s. Linear in the number of waypoints; only + -
// * / and square roots. At least one waypoint.
Trajectory min_snap(std::span<const Waypoint> waypoints, std::span<const double> times);

// The same from rest to rest, passing the points.
Trajectory min_snap(std::span<const Vec3> points, std::span<const double> times);

}  // namespace traj
