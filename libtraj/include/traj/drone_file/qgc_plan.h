#pragma once

// Missions as QGroundControl's `.plan`: JSON, file version 1, mission version 2.

#include <iosfwd>
#include <string_view>

#include "traj/drone_file/mission.h"

namespace traj {

// `station` goes into groundStation: who made it. The firmware is named as generic (PX4 and
// ArduPilot take it), the vehicle as a multirotor. The cruise and hover speeds, which only estimate
// times, are the mission's.
void write_qgc_plan(std::ostream& out, const Mission& mission, std::string_view station);

// Throws geom::InputError(source, …) for malformed JSON, another file type or version, a missing
// key, items that are not simple ones (surveys and the like, which only QGroundControl can
// expand), heights above terrain or said twice and not alike, a fence, and a vehicle that does not
// hover. Rally points only say where a return may lead, and a return is never taken for checked.
Mission read_qgc_plan(std::istream& in, std::string_view source);

}  // namespace traj
