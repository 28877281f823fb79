#pragma once

// DJI's missions: dji_wpml.h reads and writes them.

namespace traj {

struct MissionFormat;

// "dji-wpml": as a format (mission_format.h).
extern const MissionFormat kDjiWpml;

}  // namespace traj
