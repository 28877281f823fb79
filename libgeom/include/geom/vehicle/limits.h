#pragma once

// The limits of a vehicle: speeds, acceleration, jerk, tilt, thrust and rates.
//
// Example:
//   const geom::Limits slow{{geom::Limit::speed, 5}, {geom::Limit::acceleration, 3}};
//   const geom::Limits held = geom::stricter(slow, {{geom::Limit::speed, 8}});
//   assert(*held[geom::Limit::speed] == 5 && !held[geom::Limit::jerk]);  // jerk: not limited
//
// Thrust, tilt and body rates follow by differential flatness (the thrust of a quadrotor is along
// a + g). This is also the place that says which limit holds if several are given.

#include <array>
#include <cstddef>
#include <initializer_list>
#include <nlohmann/json_fwd.hpp>
#include <numbers>
#include <optional>
#include <string_view>
#include <utility>

namespace geom {

class JsonFields;
class JsonLine;

inline constexpr double kGravity = 9.80665;  // m/s2

enum class Limit {
  speed,             // m/s, Euclidean norm
  horizontal_speed,  // m/s, norm of the horizontal velocity
  vertical_speed,    // m/s, up or down
  acceleration,      // m/s2, Euclidean norm
  jerk,              // m/s3, Euclidean norm
  tilt,              // radians from upright, of the thrust direction a + g; < pi/2
  thrust,            // m/s2, norm of a + g: thrust over mass; > g
  body_rate,         // rad/s, how fast the thrust direction turns: the norm of roll and pitch rate
  yaw_rate           // rad/s, where the trajectory says the yaw
};
inline constexpr std::size_t kLimits = 9;

// How a limit is written, everywhere.
struct LimitKind {
  Limit limit;
  const char* name;      // in records and profiles
  const char* quantity;  // what it bounds: in reports and reasons
  const char* option;    // of the tools
  const char* meaning;   // of the option
  const char* unit;      // of the option, and in messages
  double in_unit = 1;    // SI of one such unit
  double least = 0;      // of the option, in its unit; both 0: any number above 0
  double most = 0;
};
inline constexpr double kRadiansPerDegree = std::numbers::pi / 180;  // radians
inline constexpr std::array<LimitKind, kLimits> kLimitKinds{{
    {Limit::speed, "vmax", "speed", "--vmax", "largest speed, m/s", "m/s"},
    {Limit::horizontal_speed, "vmax_h", "horizontal_speed", "--vmax-h",
     "largest horizontal speed, m/s", "m/s"},
    {Limit::vertical_speed, "vmax_v", "vertical_speed", "--vmax-v", "largest vertical speed, m/s",
     "m/s"},
    {Limit::acceleration, "amax", "acceleration", "--amax", "largest acceleration, m/s2", "m/s2"},
    {Limit::jerk, "jmax", "jerk", "--jmax", "largest jerk, m/s3", "m/s3"},
    {Limit::tilt, "tilt", "tilt", "--tilt", "largest tilt of the thrust from upright, degrees",
     "degrees", kRadiansPerDegree, 1, 80},
    {Limit::thrust, "thrust", "thrust", "--thrust",
     "largest thrust over mass, m/s2 (above 9.80665)", "m/s2", 1, 9.81, 1e4},
    {Limit::body_rate, "body_rate", "body_rate", "--body-rate",
     "largest rate at which the thrust turns (roll and pitch), degrees/s", "degrees/s",
     kRadiansPerDegree, 0.1, 1e5},
    {Limit::yaw_rate, "yaw_rate", "yaw_rate", "--yaw-rate", "largest yaw rate, degrees/s",
     "degrees/s", kRadiansPerDegree, 0.1, 1e4},
}};
constexpr const LimitKind& kind_of(Limit limit) {
  return kLimitKinds[static_cast<std::size_t>(limit)];
}
static_assert([] {
  for (std::size_t i = 0; i < kLimits; ++i) {
    if (kLimitKinds[i].limit != static_cast<Limit>(i)) return false;
  }
  return true;
}());

// The order in which a flight is held to its limits, and reports and certificates name them: the
// first one that is broken is the reason.
inline constexpr std::array<Limit, kLimits> kOrderOfLimits{
    Limit::speed,  Limit::acceleration,     Limit::jerk,
    Limit::tilt,   Limit::horizontal_speed, Limit::vertical_speed,
    Limit::thrust, Limit::body_rate,        Limit::yaw_rate};

// A value for each limit.
template <class T>
struct PerLimit {
  std::array<T, kLimits> values{};

  constexpr T& operator[](Limit limit) { return values[static_cast<std::size_t>(limit)]; }
  constexpr const T& operator[](Limit limit) const {
    return values[static_cast<std::size_t>(limit)];
  }
  friend bool operator==(const PerLimit&, const PerLimit&) = default;
};

// Absent = not limited. All are closed: reaching the limit is allowed.
struct Limits : PerLimit<std::optional<double>> {
  Limits() = default;
  Limits(std::initializer_list<std::pair<Limit, double>> given) {
    for (const auto& [limit, value] : given) (*this)[limit] = value;
  }
};

// The smaller of each limit, or the only one.
Limits stricter(const Limits& a, const Limits& b);

// The first limit that `a` sets above `b`'s, if any. What `a` does not set is not asked.
std::optional<Limit> first_above(const Limits& a, const Limits& b);

// Where the limits of one flight come from.
struct LimitSources {
  Limits options;           // of this run
  Limits record;            // asked for when it was made
  Limits vehicle;           // of the vehicle whose box is used: its tilt is what the box holds
  bool overridden = false;  // --override: the options alone decide what they name
};

// The limits that hold. Each is the strictest that any source says; with `overridden`, a limit that
// the options name is as they say. The tilt is never above the vehicle's, because its box would not
// hold it. Every tool decides by this function.
Limits limits_that_hold(const LimitSources& sources);

// Adds the member "limits" to a record, unless there are none.
void add(JsonLine& line, const Limits& limits);

// The member "limits" of a record; none without it. Throws InputError unless each is > 0, the tilt
// below a right angle and the thrust above kGravity; and for a limit that is not known, because
// what was meant as a limit must not be passed over.
Limits read_limits(const JsonFields& fields);
Limits read_limits(const JsonFields& fields, const nlohmann::json& value, std::string_view what);

}  // namespace geom
