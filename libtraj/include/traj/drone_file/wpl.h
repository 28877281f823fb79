#pragma once

// Missions as `QGC WPL 110` text, which Mission Planner, QGroundControl, MAVProxy and MAVSDK read.

#include <iosfwd>
#include <string_view>

#include "traj/drone_file/mission.h"

namespace traj {

// Home as item 0 (in frame 0, as Mission Planner keeps it), then the items: 12 fields between tabs,
// index, current, frame, command, four parameters, latitude, longitude, altitude, autocontinue.
void write_wpl(std::ostream& out, const Mission& mission);

// Item 0 is home where it is a waypoint in frame 0. Throws geom::InputError(source, line, …) for
// another version, CRLF, fields that are missing or no numbers, an index that is not the next, and
// a mission that begins (is current) at a later item. A line that was cut misses fields; a file
// that was cut between lines reads as a shorter mission (see FlownMission::ended).
Mission read_wpl(std::istream& in, std::string_view source);

}  // namespace traj
