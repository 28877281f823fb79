#pragma once

// `QGC WPL 110` text: missions as Mission Planner, QGroundControl, MAVProxy and MAVSDK read them.
//
// Example:
//   const traj::Mission mission = traj::make_mission({{{0, 0, 30}, {80, 0, 30}}},
//                                                    {.origin = {47.4, 8.5, 400}}, {});
//   std::stringstream file;
//   traj::write_wpl(file, mission);
//   assert(traj::read_wpl(file, "mission.waypoints").items.size() == mission.items.size());

#include <iosfwd>
#include <string_view>

#include "traj/mission/mavlink/mission.h"

namespace traj {

// Home as item 0 (in frame 0, as Mission Planner keeps it), then the items: 12 fields between tabs,
// index, current, frame, command, four parameters, latitude, longitude, altitude, autocontinue.
void write_wpl(std::ostream& out, const Mission& mission);

// Its fences, and its rally points, each as a file of its own, as ArduPilot's ground stations load
// them: home as item 0, then corners of fences (5001 to 5004) or rally points (5100).
void write_wpl_fences(std::ostream& out, const Mission& mission);
void write_wpl_rally(std::ostream& out, const Mission& mission);

// Version 110: item 0 is home where it is a waypoint in frame 0; 120: no item is. Lines may end
// with CRLF, and the file may begin with a byte order mark; `#` begins a comment. Items may begin
// at 1 and leave numbers out, as ground stations count them anew (a note says so), but not where a
// jump counts on them. Items of fences (5001 to 5004) are the mission's fences, and rally points
// (5100) its own. Throws geom::InputError(source, line, …) for another version, fields that are
// missing or no numbers, numbers that do not rise, a second header, a fence whose corners are not
// as many as they say, and a mission that begins (is current) at a later item. A line that was cut
// misses fields; a file that was cut between lines reads as a shorter mission (see
// FlownMission::ended).
Mission read_wpl(std::istream& in, std::string_view source);

// Its fences alone, and its rally points; a file without a mission will do.
std::vector<GeodeticFence> read_wpl_fences(std::istream& in, std::string_view source);
std::vector<geom::GeodeticPlace> read_wpl_rally(std::istream& in, std::string_view source);

}  // namespace traj
