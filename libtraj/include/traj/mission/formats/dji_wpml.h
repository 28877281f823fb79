#pragma once

// DJI's missions: dji_wpml.h reads and writes them.
//
// No example: a constant; traj/mission/export_mission.h shows how to write in a format.

namespace traj {

struct MissionFormat;

// "dji-wpml": as a format (mission_format.h).
extern const MissionFormat kDjiWpml;

}  // namespace traj
