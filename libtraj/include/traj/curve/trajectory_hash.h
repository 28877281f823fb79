#pragma once

// Identifies a trajectory by its numbers, for what was found out about it alone.
//
// Example:
//   traj::Trajectory other = trajectory;
//   other.segments.front().duration *= 2;
//   assert(traj::trajectory_hash(trajectory).size() == 64);
//   assert(traj::trajectory_hash(other) != traj::trajectory_hash(trajectory));

#include <string>

#include "traj/curve/trajectory.h"

namespace traj {

// SHA-256, in hexadecimal, over the number of segments and, of each segment, its duration, its
// control points, and the control points of its yaw (with their number before them), all as
// little-endian float64. Coordinates count as they stand, in whatever axes; -0 counts as 0.
std::string trajectory_hash(const Trajectory& trajectory);

}  // namespace traj
