#pragma once

// Lines in KML: geo_line.h reads and writes them.

namespace traj {

struct MissionFormat;

// "kml": as a format (mission_format.h).
extern const MissionFormat kKml;

}  // namespace traj
