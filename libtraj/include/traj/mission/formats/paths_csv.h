#pragma once

// Tables of paths, which no drone takes: columns id,x,y,z along the map's axes.

namespace traj {

struct MissionFormat;

// "paths-csv": as a format (mission_format.h).
extern const MissionFormat kPathsCsv;

}  // namespace traj
