#pragma once

// How long an autopilot takes for a mission: an estimate for people, which proves nothing.
//
// Example:
//   const traj::Mission mission = traj::make_mission({{{0, 0, 30}, {80, 0, 30}}},
//                                                    {.origin = {47.4, 8.5, 400}}, {.speed = 6});
//   const traj::MissionTime time = traj::mission_time(mission, traj::px4());
//   assert(time.seconds > 80 / 6.0);

#include <cstddef>

#include "traj/mission/firmware/autopilot.h"
#include "traj/mission/mavlink/mission.h"

namespace traj {

// From the top of the take-off to the last waypoint, in calm air.
struct MissionTime {
  double seconds = 0;
  std::size_t waypoints = 0;
  std::size_t rests = 0;  // of these
};

// Of a mission of take-off, waypoints, speeds and a landing, as make_mission makes them; items of
// other kinds take no time. A leg from rest to rest takes the S-curve of the autopilot's
// acceleration and jerk, its speed and its rates of climb and descent, and the hold behind it; legs
// that pass into one another count as one. The default speed is the autopilot's.
MissionTime mission_time(const Mission& mission, const Autopilot& autopilot);

// Seconds from rest to rest over `length` metres (0 or more), no faster than `speed` m/s, with that
// acceleration (m/s2) and jerk (m/s3), all above 0.
double rest_to_rest(double length, double speed, double acceleration, double jerk);

}  // namespace traj
