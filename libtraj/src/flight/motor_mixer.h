#pragma once

// From collective thrust and torques to four motors that each can only do so much.

#include "traj/flight/quadrotor.h"

namespace traj {

struct Mixed {
  Motors command = Motors::Zero();  // N, within the motors' range
  double thrust = 0;                // N: what is left of the collective thrust,
  Vec3 torque = Vec3::Zero();       // N m: and of the torques
  bool saturated = false;           // whether anything was given up
};

// Gives up yaw first, then thrust, and of roll and pitch only what does not fit the motors' range
// at any thrust.
Mixed mix(const Quadrotor& quadrotor, double thrust, const Vec3& torque);

}  // namespace traj
