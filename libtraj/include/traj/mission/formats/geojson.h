#pragma once

// Lines in GeoJSON: geo_line.h reads and writes them.

namespace traj {

struct MissionFormat;

// "geojson": as a format (mission_format.h).
extern const MissionFormat kGeojson;

}  // namespace traj
