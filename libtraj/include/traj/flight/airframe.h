#pragma once

// What a vehicle is made of: mass, inertia, motors, drag, battery.
//
// Example:
//   traj::Airframe airframe;
//   airframe.mass = 0.08;                       // kg
//   assert(!traj::quadrotor_of(airframe));      // more must be known to simulate it

#include <optional>

#include "geom/base/vec3.h"
#include "traj/flight/gains.h"

namespace traj {

struct Airframe {
  std::optional<double> mass;                 // kg, > 0
  std::optional<geom::Vec3> inertia;          // kg m2 about the body's axes, > 0
  std::optional<double> motor_time_constant;  // s, > 0
  std::optional<double> thrust_least;         // N, of all motors, >= 0
  std::optional<double> thrust_most;          // N, of all motors, above the least and the weight
  std::optional<geom::Vec3> body_rate_max;    // rad/s about the body's axes, > 0
  std::optional<Eigen::Vector2d> arm;         // m: motors at (+-x, +-y), > 0
  std::optional<double> torque_per_thrust;    // m, > 0: of a motor about its axis
  std::optional<geom::Vec3> drag;             // kg/s along the body's axes, >= 0: linear
  std::optional<double> battery;              // Wh, > 0
  std::optional<Gains> gains;                 // where all is known that flight takes
  std::optional<double> ceiling;              // m above the ground, > 0
  std::optional<double> range;                // m from the pilot, > 0
  std::optional<double> endurance;            // s in the air, > 0
};

// What flight takes, or nothing where the mass, inertia, motor_time_constant, thrust, arm or
// torque_per_thrust is not known. Unknown drag is none, unknown body rates are PX4's defaults.
std::optional<Quadrotor> quadrotor_of(const Airframe& airframe);

}  // namespace traj
