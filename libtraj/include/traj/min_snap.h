#pragma once

// The trajectory of least snap through waypoints at given times.

#include <span>

#include "traj/trajectory.h"

namespace traj {

// Minimises the integral of |fourth derivative|^2 over all curves that pass the waypoints after
// the given leg times (seconds, > 0 for legs of positive length; one fewer than waypoints), at rest
// (v = a = j = 0) at both ends. Legs between equal points are dropped, with their time; when
// nothing is left the result rests for the sum of the times (1 s when that is 0). Linear in the
// number of waypoints; only + - * / and square roots. At least one waypoint.
Trajectory min_snap(std::span<const Vec3> waypoints, std::span<const double> times);

}  // namespace traj
