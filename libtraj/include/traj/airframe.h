#pragma once

// What a vehicle is made of, as far as it is known: what flying it takes beyond its shape.

#include <optional>

#include "geom/vec3.h"

namespace traj {

struct Airframe {
  std::optional<double> mass;                 // kg, > 0
  std::optional<geom::Vec3> inertia;          // kg m2 about the body's axes, > 0
  std::optional<double> motor_time_constant;  // s, > 0
  std::optional<double> thrust_least;         // N, of all motors, >= 0
  std::optional<double> thrust_most;          // N, of all motors, above the least and the weight
  std::optional<geom::Vec3> body_rate_max;    // rad/s about the body's axes, > 0
  std::optional<double> ceiling;              // m above the ground, > 0
  std::optional<double> range;                // m from the pilot, > 0
  std::optional<double> endurance;            // s in the air, > 0
};

}  // namespace traj
