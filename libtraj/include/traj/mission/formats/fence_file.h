#pragma once

// The fences of a file, whatever else is in it.
//
// Example, not run:
//   std::ifstream in("fenced.plan");
//   const std::vector<traj::GeodeticFence> fences = traj::read_fences(in, "fenced.plan");
//   std::cout << fences.size() << " fences\n";

#include <iosfwd>
#include <string_view>
#include <vector>

#include "traj/mission/flown/fence.h"

namespace traj {

// Of a QGroundControl plan, or of a `QGC WPL` file with or without a mission. Throws
// geom::InputError(source, …) where such a file cannot be read (wpl.h, qgc_plan.h), and where it
// has no fence.
std::vector<GeodeticFence> read_fences(std::istream& in, std::string_view source);

// Whether a text that begins like this has no items but home, fences (MAV_CMD 5000 to 5004) and
// rally points (5100), as far as it is there: Mission Planner writes them as it writes missions.
bool is_fence_text(std::string_view head);

}  // namespace traj
