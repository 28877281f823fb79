#pragma once

// The speeds that a mission's items ask for.

#include <vector>

#include "mission_clock.h"
#include "mission_track.h"

namespace traj {

class MissionSpeeds {
 public:
  // An item of speed (178): for the legs from here on.
  void take(const MissionItem& item, FlownTrack& track, MissionClock& clock);
  // The rules' autopilots with what the user says of their settings, and the largest rates of climb
  // and descent that were asked for.
  std::vector<Autopilot> as_set(const MissionRules& rules) const;

 private:
  double most_climb_ = 0;  // m/s
  double most_descent_ = 0;
};

}  // namespace traj
