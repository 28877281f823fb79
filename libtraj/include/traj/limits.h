#pragma once

// What the vehicle may do: bounds on velocity, acceleration and jerk, and on thrust, tilt and body
// rates by differential flatness (the thrust of a quadrotor is along a + g).

#include <optional>

namespace traj {

inline constexpr double kGravity = 9.80665;  // m/s2

// Absent = not limited. All are closed: reaching the limit is allowed.
struct Limits {
  std::optional<double> vmax;       // m/s, Euclidean norm
  std::optional<double> amax;       // m/s2, Euclidean norm
  std::optional<double> jmax;       // m/s3, Euclidean norm
  std::optional<double> tilt;       // radians from upright, of the thrust direction a + g; < pi/2
  std::optional<double> vmax_h;     // m/s, norm of the horizontal velocity
  std::optional<double> vmax_v;     // m/s, up or down
  std::optional<double> thrust;     // m/s2, norm of a + g: thrust over mass; > g
  std::optional<double> body_rate;  // rad/s, how fast the thrust direction turns: the norm of roll
                                    // and pitch rate
  std::optional<double> yaw_rate;   // rad/s, where the trajectory says the yaw

  friend bool operator==(const Limits&, const Limits&) = default;
};

// All of them, as records name them.
struct LimitField {
  const char* name;
  std::optional<double> Limits::*member;
};
inline constexpr LimitField kLimitFields[] = {
    {"vmax", &Limits::vmax},     {"vmax_h", &Limits::vmax_h},       {"vmax_v", &Limits::vmax_v},
    {"amax", &Limits::amax},     {"jmax", &Limits::jmax},           {"tilt", &Limits::tilt},
    {"thrust", &Limits::thrust}, {"body_rate", &Limits::body_rate}, {"yaw_rate", &Limits::yaw_rate},
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
