#pragma once

// Trajectories of other people's files, whose segments meet as well as their decimals allow.
//
// Example:
//   traj::Trajectory rounded = trajectory;
//   rounded.segments[0].point.back().x() += 1e-7;  // as a file with few decimals has it
//   const traj::ClosedJoints closed = traj::close_joints(rounded, 1e-3, "flight.csv");
//   assert(closed.largest_gap < 2e-7);

#include <string_view>

#include "traj/curve/trajectory.h"

namespace traj {

struct ClosedJoints {
  Trajectory trajectory;
  double largest_gap = 0;  // m, of position
};

// The segments with the mean of both positions, velocities and accelerations where they meet; each
// keeps its own jerk there. Yaw and its rate likewise, whole turns taken away. Throws
// geom::InputError(source, …) with segment, time and gap for the first joint that misses by more
// than `gap` metres, 10 gap m/s or 100 gap m/s2, or by `gap` radians or 10 gap rad/s of yaw.
ClosedJoints close_joints(const Trajectory& trajectory, double gap, std::string_view source);

}  // namespace traj
