#pragma once

// Tables of paths, which no drone takes: columns id,x,y,z along the map's axes.
//
// No example: a constant; traj/mission/read_mission.h shows how to read a format.

namespace traj {

struct MissionFormat;

// "paths-csv": as a format (mission_format.h).
extern const MissionFormat kPathsCsv;

}  // namespace traj
