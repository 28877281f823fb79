#pragma once

// Turns on a circle: whether a file says where that is.

#include <string_view>

#include "mission/flown/flown_regions.h"
#include "traj/mission/mavlink/mission.h"

namespace traj {

// Each throws geom::InputError(source, line, …) at the item where it must refuse.

double require_radius(const MissionItem& item, double radius, std::string_view source);

void require_whole_turns(const MissionItem& item, std::string_view source);

// The circle that the item turns on, of a radius that ArduPilot can keep.
Circle circle_of(const MissionItem& item, const Vec3& centre, std::string_view source);

// From points where it may be, each far enough from the centre.
void require_known_entry(const Circle& circle, const Hull& from, const MissionItem& item,
                         std::string_view source);

}  // namespace traj
