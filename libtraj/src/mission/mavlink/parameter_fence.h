#pragma once

// Fences that an autopilot's parameters make: a highest altitude, and a circle around home.

#include <span>
#include <string_view>

#include "traj/mission/mavlink/mission_flight.h"

namespace traj {

// Throws geom::InputError(source, …) where the way of the mission leaves the fence of one of them,
// since that one then leaves the mission, or where home is not known.
void require_within_fence(const FlownMavlink& flown, std::span<const Autopilot> autopilots,
                          std::string_view source);

}  // namespace traj
