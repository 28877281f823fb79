#pragma once

// The speeds that a mission's items ask for.

#include <vector>

#include "mission_clock.h"
#include "mission_track.h"

namespace traj {

class MissionSpeeds {
 public:
  explicit MissionSpeeds(const MissionRules& rules) : rules_(rules) {}  // must outlive it

  // Behind a condition (112, 114, 115), and up to the next item that moves something, ArduPilot may
  // come to a change of speed late, or never.
  void begin_condition() { waits_ = true; }
  void end_condition() { waits_ = false; }
  // An item of speed (178): for the legs from here on, as each autopilot takes it.
  void take(const MissionItem& item, FlownTrack& track, MissionClock& clock);
  // The rules' autopilots with what the user says of their settings, and the largest rates of climb
  // and descent that were asked for.
  std::vector<Autopilot> as_set() const;

 private:
  double own() const;  // m/s: the vehicle's, the fastest that may fly it

  const MissionRules& rules_;
  bool waits_ = false;
  double most_climb_ = 0;  // m/s
  double most_descent_ = 0;
};

}  // namespace traj
