#pragma once

// How long a mission takes at least: an estimate. It counts every leg, hold and turn that is flown,
// and not what speeding up costs; mission_time() counts that, of waypoints alone.

#include <algorithm>
#include <span>

#include "traj/mission/firmware/autopilot.h"

namespace traj {

// The slowest of the autopilots counts wherever the file says no speed.
class MissionClock {
 public:
  explicit MissionClock(std::span<const Autopilot> autopilots);

  // m/s, from here on.
  void say_speed(double speed) { speed_ = speed; }
  void say_no_speed() { speed_ = own_speed_; }
  // At that speed (at its own), or at the one before.
  void may_go_at(double speed) { speed_ = std::min(speed_, speed); }
  void may_go_at_own() { may_go_at(own_speed_); }
  void say_climb(double speed) { climb_ = speed; }
  void say_descent(double speed) { descent_ = speed; }

  void go(const Vec3& way);
  void wait(double seconds) { seconds_ += seconds; }
  // At ArduPilot's default rate (CIRCLE_RATE) or the speed, whichever takes longer.
  void turn(double turns, double radius);
  double seconds() const { return seconds_; }

 private:
  double own_speed_;
  double speed_ = own_speed_;
  double climb_;
  double descent_;
  double seconds_ = 0;
};

}  // namespace traj
