#pragma once

// What a vehicle may do: bounds on velocity, acceleration and jerk, and on thrust, tilt and body
// rates by differential flatness (the thrust of a quadrotor is along a + g). And which of them hold
// where several say some.

#include <optional>

namespace geom {

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

// Of each limit the smaller, or the only one.
Limits stricter(const Limits& a, const Limits& b);

// The first limit (in the order of kLimitFields) that `a` sets above `b`'s, or null. What `a` does
// not set is not asked.
const LimitField* first_above(const Limits& a, const Limits& b);

// The first limit of `b` that `a` exceeds or lacks, or null: whether `a` allows more than `b`.
const LimitField* first_looser(const Limits& a, const Limits& b);

// Who says limits of one flight.
struct LimitSources {
  Limits options;           // asked for now
  Limits record;            // asked for when it was made
  Limits vehicle;           // of the vehicle whose box is used: its tilt is what the box holds
  bool overridden = false;  // --override: the options alone decide what they name
};

// The limits that hold: of each the strictest that any of them says, or with `overridden` what the
// options say, where they say one. The tilt is never above the vehicle's: its box would not hold
// it. The one place where this is decided, for every tool.
Limits limits_that_hold(const LimitSources& sources);

}  // namespace geom
