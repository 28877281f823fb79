#include "mission_speeds.h"

#include <algorithm>

namespace traj {

// -1: as it is; other values that are no speed: the vehicle's own, which the file does not say.
void MissionSpeeds::take(const MissionItem& item, FlownTrack& track, MissionClock& clock) {
  constexpr double kClimb = 2;  // the types of rates of climb and descent
  constexpr double kDescent = 3;
  const double speed = item.param[1];
  if (item.param[0] == kClimb && speed > 0) {
    most_climb_ = std::max(most_climb_, speed);
    clock.say_climb(speed);
  }
  if (item.param[0] == kDescent && speed > 0) {
    most_descent_ = std::max(most_descent_, speed);
    clock.say_descent(speed);
  }
  if (item.param[0] == kClimb || item.param[0] == kDescent) return;
  if (speed > 0) {
    track.say_speed(speed);
    clock.say_speed(speed);
  } else if (speed != -1) {
    track.say_no_speed();
    clock.say_no_speed();
  }
}

std::vector<Autopilot> MissionSpeeds::as_set(const MissionRules& rules) const {
  std::vector<Autopilot> out = rules.autopilots;
  for (Autopilot& one : out) {
    if (one.heeds_item_radius) one.acceptance = rules.acceptance.value_or(one.acceptance);
    one.speed = rules.speed.value_or(one.speed);
    one.climb = std::max(one.climb, most_climb_);
    one.descent = std::max(one.descent, most_descent_);
  }
  return out;
}

}  // namespace traj
