#pragma once

// A vehicle that flies, and a line for it to fly along.

#include "traj/flight/simulate.h"

namespace traj::testing {

inline FlightOptions example_flight() {
  FlightOptions o;
  Quadrotor& q = o.quadrotor;
  q.mass = 1;
  q.inertia = {0.01, 0.01, 0.02};
  q.arm = {0.15, 0.15};
  q.motor_time_constant = 0.02;
  q.motor_most = 6;
  q.drag = Vec3::Constant(0.1);
  o.gains = nominal_gains(q, 0.6);
  return o;
}

// From rest at the origin to rest.
inline Trajectory line(const Vec3& to, double seconds) {
  State end;
  end.position = to;
  return {{hermite({}, end, seconds)}};
}

}  // namespace traj::testing
