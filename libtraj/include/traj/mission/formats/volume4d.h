#pragma once

// Flights as volumes of airspace for other operators (ASTM F3548): flight_volumes.h makes them.
//
// No example: a constant; traj/mission/export_mission.h shows how to write in a format.

namespace traj {

struct MissionFormat;

// "volume4d": as a format (mission_format.h).
extern const MissionFormat kVolume4d;

}  // namespace traj
