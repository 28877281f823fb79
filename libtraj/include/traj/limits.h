#pragma once

// What the vehicle may do: bounds on the norms of velocity, acceleration and jerk, and on tilt.

#include <optional>

namespace traj {

inline constexpr double kGravity = 9.80665;  // m/s2

// Absent = not limited. All are closed: reaching the limit is allowed.
struct Limits {
  std::optional<double> vmax;  // m/s, Euclidean norm
  std::optional<double> amax;  // m/s2, Euclidean norm
  std::optional<double> jmax;  // m/s3, Euclidean norm
  std::optional<double> tilt;  // radians from upright, of the thrust direction a + g; < pi/2

  friend bool operator==(const Limits&, const Limits&) = default;
};

}  // namespace traj
