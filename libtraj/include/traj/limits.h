#pragma once

// What the vehicle may do: bounds on velocity, acceleration and jerk, and on thrust and tilt by
// differential flatness (the thrust of a quadrotor is along a + g).

#include <optional>

namespace traj {

inline constexpr double kGravity = 9.80665;  // m/s2

// Absent = not limited. All are closed: reaching the limit is allowed.
struct Limits {
  std::optional<double> vmax;    // m/s, Euclidean norm
  std::optional<double> amax;    // m/s2, Euclidean norm
  std::optional<double> jmax;    // m/s3, Euclidean norm
  std::optional<double> tilt;    // radians from upright, of the thrust direction a + g; < pi/2
  std::optional<double> vmax_h;  // m/s, norm of the horizontal velocity
  std::optional<double> vmax_v;  // m/s, up or down
  std::optional<double> thrust;  // m/s2, norm of a + g: thrust over mass; > g

  friend bool operator==(const Limits&, const Limits&) = default;
};

// All of them, as records name them.
struct LimitField {
  const char* name;
  std::optional<double> Limits::*member;
};
inline constexpr LimitField kLimitFields[] = {
    {"vmax", &Limits::vmax},     {"vmax_h", &Limits::vmax_h}, {"vmax_v", &Limits::vmax_v},
    {"amax", &Limits::amax},     {"jmax", &Limits::jmax},     {"tilt", &Limits::tilt},
    {"thrust", &Limits::thrust},
};

// Each limit as pick(a's, b's) says.
template <class Pick>
Limits combined(const Limits& a, const Limits& b, const Pick& pick) {
  Limits out;
  for (const LimitField& field : kLimitFields) {
    out.*field.member = pick(a.*field.member, b.*field.member);
  }
  return out;
}

}  // namespace traj
