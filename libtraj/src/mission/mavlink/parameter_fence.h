#pragma once

// Fences that an autopilot's parameters make: a highest and a lowest altitude, and a circle around
// home.

#include <span>
#include <string_view>

#include "traj/mission/mavlink/mission_flight.h"

namespace traj {

// Throws geom::InputError(source, …) where the mission may leave the fence of one of them, on its
// way or where it strays from that, since that one then leaves the mission, or where home is not
// known. The lowest altitude counts for the way alone: not for landings, and only once it was above
// it.
void require_within_fence(const FlownMavlink& flown, std::span<const Autopilot> autopilots,
                          std::string_view source);

}  // namespace traj
