#pragma once

// How smooth a trajectory is: its snap, and the integrals by which planners are compared.
//
// Example:
//   const traj::State end{.position = {4, 0, 0}};
//   const traj::Trajectory hop{{traj::hermite(traj::State{}, end, 2)}};
//   assert(traj::smoothness(hop).snap > 0);

#include "traj/curve/trajectory.h"

namespace traj {

// The fourth derivative of the position at time t, clamped to [0, duration], in m/s4. At a joint:
// that of the later segment; snap may jump there. The trajectory has at least one segment.
Vec3 snap(const Trajectory& trajectory, double t);

struct Smoothness {
  double jerk = 0;  // integral over time of |third derivative|^2, m2/s5
  double snap = 0;  // integral over time of |fourth derivative|^2, m2/s7
};

// Of the whole trajectory, by the exact formula for polynomials, in double precision. Yaw does not
// count, and neither do jumps at joints.
Smoothness smoothness(const Trajectory& trajectory);

}  // namespace traj
