#pragma once

// Lines in GeoJSON: geo_line.h reads and writes them.
//
// No example: a constant; traj/mission/export_mission.h shows how to write in a format.

namespace traj {

struct MissionFormat;

// "geojson": as a format (mission_format.h).
extern const MissionFormat kGeojson;

}  // namespace traj
