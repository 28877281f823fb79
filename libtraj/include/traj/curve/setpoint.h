#pragma once

// Where a vehicle is to be at one instant, and how it is to move there.
//
// Example:
//   traj::Setpoint hover;
//   hover.time = 2;
//   hover.state.position = {1, 1, 1.5};

#include "traj/curve/trajectory.h"

namespace traj {

struct Setpoint {
  double time = 0;  // s
  State state;      // without jerk
  double yaw = 0;   // rad
  double yaw_rate = 0;
};

}  // namespace traj
