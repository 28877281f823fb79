#pragma once

// QGroundControl's plans (`.plan`): missions as JSON, file version 1, mission version 2.
//
// Example:
//   std::ifstream in("mission.plan");
//   const traj::Mission mission = traj::read_qgc_plan(in, "mission.plan");
//   assert(!mission.items.empty());
//   std::ostringstream out;
//   traj::write_qgc_plan(out, mission, "my station");

#include <iosfwd>
#include <string_view>

#include "traj/mission/mavlink/mission.h"

namespace traj {

// `station` goes into groundStation: who made it. The firmware is named as generic (PX4 and
// ArduPilot take it), the vehicle as a multirotor. The cruise and hover speeds, which only estimate
// times, are the mission's.
void write_qgc_plan(std::ostream& out, const Mission& mission, std::string_view station);

// Simple items, and those that surveys and the like hold; fences and rally points. Throws
// geom::InputError(source, …) for malformed JSON, another file type or version, a missing key,
// other complex items (which only QGroundControl can expand), heights that are said twice and not
// alike, and a vehicle that does not hover.
Mission read_qgc_plan(std::istream& in, std::string_view source);

// Its fences alone; the rest of the plan is not looked at.
std::vector<GeodeticFence> read_qgc_fences(std::istream& in, std::string_view source);

}  // namespace traj
