#pragma once

// Lines in KML: geo_line.h reads and writes them.
//
// No example: a constant; traj/mission/export_mission.h shows how to write in a format.

namespace traj {

struct MissionFormat;

// "kml": as a format (mission_format.h).
extern const MissionFormat kKml;

}  // namespace traj
