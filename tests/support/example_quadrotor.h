#pragma once

// A quadrotor whose numbers all differ, so that none can stand for another.

#include "traj/flight/quadrotor.h"

namespace support {

inline traj::Quadrotor example_quadrotor() {
  traj::Quadrotor q;
  q.mass = 0.8;
  q.inertia = {0.004, 0.006, 0.009};
  q.arm = {0.12, 0.15};
  q.torque_per_thrust = 0.02;
  q.motor_time_constant = 0.03;
  q.motor_least = 0.1;
  q.motor_most = 6;
  q.drag = {0.2, 0.3, 0.1};
  return q;
}

}  // namespace support
