#include "mission_speeds.h"

#include <algorithm>
#include <iterator>

#include "mission_autopilots.h"

namespace traj {

// PX4 (Navigator::run) flies its legs at a speed of any type. A speed that is not above 0 restores
// its own speed. ArduPilot (ModeAuto::do_change_speed) obeys the types, and ignores a speed that is
// not above 0, or that is below the least of its legs (AC_WPNav::set_speed_NE_cms).
void MissionSpeeds::take(const MissionItem& item, FlownTrack& track, MissionClock& clock) {
  constexpr double kLevel[] = {0, 1};  // the types of speeds through the air and over ground
  constexpr double kClimb = 2;
  constexpr double kDescent = 3;
  constexpr double kLeastOfArdupilot = 0.2;  // m/s; 0.1 in newer versions
  const double type = item.param[0];
  const double speed = item.param[1];
  const bool px4 = !flown_by(Firmware::ardupilot, rules_);
  const bool ardupilot = !flown_by(Firmware::px4, rules_);
  if (!(speed > 0)) {
    if (px4 && ardupilot) {
      track.may_fly_at_own(own());
      clock.may_go_at_own();
    } else if (px4) {
      track.say_no_speed();
      clock.say_no_speed();
    }
    return;
  }
  if (type == kClimb) {
    most_climb_ = std::max(most_climb_, speed);
    clock.say_climb(speed);
  }
  if (type == kDescent) {
    most_descent_ = std::max(most_descent_, speed);
    clock.say_descent(speed);
  }
  const bool level = std::find(std::begin(kLevel), std::end(kLevel), type) != std::end(kLevel);
  const bool may_ignore = ardupilot && (waits_ || speed < kLeastOfArdupilot);
  if (level ? !may_ignore : !ardupilot) {
    track.say_speed(speed);
    clock.say_speed(speed);
  } else if (level || px4) {
    track.may_fly_at(speed, own());
    clock.may_go_at(speed);
  }
}

double MissionSpeeds::own() const {
  if (rules_.speed) return *rules_.speed;
  double most = rules_.autopilots.empty() ? kUnsaidSpeed : 0;
  for (const Autopilot& one : rules_.autopilots) most = std::max(most, one.speed);
  return most;
}

std::vector<Autopilot> MissionSpeeds::as_set() const {
  std::vector<Autopilot> out = rules_.autopilots;
  for (Autopilot& one : out) {
    if (one.heeds_item_radius) one.acceptance = rules_.acceptance.value_or(one.acceptance);
    one.speed = rules_.speed.value_or(one.speed);
    one.climb = std::max(one.climb, most_climb_);
    one.descent = std::max(one.descent, most_descent_);
  }
  return out;
}

}  // namespace traj
