#pragma once

// Why something is refused: the first that holds, as reports name it.
//
// Example:
//   assert(traj::name(traj::broken(traj::Limit::tilt)) == "tilt");
//   assert(traj::name(traj::unmeasured(traj::Limit::tilt)) == "tilt_not_measured");

#include <string_view>

#include "geom/text/words.h"
#include "traj/proof/limits.h"

namespace traj {

enum class Reason {
  none,  // it is not refused
  // Nothing to check.
  no_path,
  infeasible,
  stopped,
  // Numbers that cannot be judged (domain.h); also the vehicle's half sizes or margin.
  duration,
  coordinates,
  limits,
  vehicle,
  // Its way. Undecided: the way between two samples could not be bounded.
  discontinuous,
  bounds,
  collision,
  undecided,
  // A limit that does not hold, in the order of Limit.
  speed,
  horizontal_speed,
  vertical_speed,
  acceleration,
  jerk,
  tilt,
  thrust,
  body_rate,
  yaw_rate,
  // A limit that was asked for and is not measured, in the same order.
  speed_not_measured,
  horizontal_speed_not_measured,
  vertical_speed_not_measured,
  acceleration_not_measured,
  jerk_not_measured,
  tilt_not_measured,
  thrust_not_measured,
  body_rate_not_measured,
  yaw_rate_not_measured,
  // A mission: the way up, what it lands on, the autopilot's envelope, a return that it does not
  // say, a place other than the trajectory's end, a fence.
  takeoff,
  landing,
  ceiling,
  range,
  endurance,
  return_home,
  end,
  fence,
  // A record's own bound on its duration, or on the length of paths, that cannot be.
  duration_bound
};
inline constexpr geom::Words<Reason, 39> kReasonWords{{
    {Reason::none, ""},
    {Reason::no_path, "no_path"},
    {Reason::infeasible, "infeasible"},
    {Reason::stopped, "stopped"},
    {Reason::duration, "duration"},
    {Reason::coordinates, "coordinates"},
    {Reason::limits, "limits"},
    {Reason::vehicle, "vehicle"},
    {Reason::discontinuous, "discontinuous"},
    {Reason::bounds, "bounds"},
    {Reason::collision, "collision"},
    {Reason::undecided, "undecided"},
    {Reason::speed, "speed"},
    {Reason::horizontal_speed, "horizontal_speed"},
    {Reason::vertical_speed, "vertical_speed"},
    {Reason::acceleration, "acceleration"},
    {Reason::jerk, "jerk"},
    {Reason::tilt, "tilt"},
    {Reason::thrust, "thrust"},
    {Reason::body_rate, "body_rate"},
    {Reason::yaw_rate, "yaw_rate"},
    {Reason::speed_not_measured, "speed_not_measured"},
    {Reason::horizontal_speed_not_measured, "horizontal_speed_not_measured"},
    {Reason::vertical_speed_not_measured, "vertical_speed_not_measured"},
    {Reason::acceleration_not_measured, "acceleration_not_measured"},
    {Reason::jerk_not_measured, "jerk_not_measured"},
    {Reason::tilt_not_measured, "tilt_not_measured"},
    {Reason::thrust_not_measured, "thrust_not_measured"},
    {Reason::body_rate_not_measured, "body_rate_not_measured"},
    {Reason::yaw_rate_not_measured, "yaw_rate_not_measured"},
    {Reason::takeoff, "takeoff"},
    {Reason::landing, "landing"},
    {Reason::ceiling, "ceiling"},
    {Reason::range, "range"},
    {Reason::endurance, "endurance"},
    {Reason::return_home, "return"},
    {Reason::end, "end"},
    {Reason::fence, "fence"},
    {Reason::duration_bound, "duration_bound"},
}};
constexpr std::string_view name(Reason reason) { return geom::word_of(kReasonWords, reason); }

// That a limit does not hold, or is not measured.
constexpr Reason broken(Limit limit) {
  return static_cast<Reason>(static_cast<int>(Reason::speed) + static_cast<int>(limit));
}
constexpr Reason unmeasured(Limit limit) {
  return static_cast<Reason>(static_cast<int>(Reason::speed_not_measured) +
                             static_cast<int>(limit));
}
static_assert([] {
  for (const LimitKind& kind : kLimitKinds) {
    const std::string_view missing = name(unmeasured(kind.limit));
    const std::string_view quantity = kind.quantity;
    if (name(broken(kind.limit)) != quantity) return false;
    if (missing.substr(0, quantity.size()) != quantity) return false;
    if (missing.substr(quantity.size()) != "_not_measured") return false;
  }
  return true;
}());

}  // namespace traj
