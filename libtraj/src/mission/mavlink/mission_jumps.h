#pragma once

// The order in which a mission's items are flown.

#include <string_view>
#include <vector>

#include "geom/base/error.h"
#include "traj/mission/mavlink/mission.h"

namespace traj {

// Indices of items, jumps taken as often as they say and left out. ArduPilot Copter and PX4 count
// how often a jump was taken over the whole mission, so a jump within a jump's loop is used up
// once. A jump for ever (below 0 times) is taken twice, and counted in `endless`: the second round
// begins as all that follow do. Throws geom::InputError(source, line, …) for a jump to where no
// item is, and more than kMostItems items in all.
std::vector<std::size_t> flown_order(const Mission& mission, std::string_view source,
                                     std::size_t& endless);

// Refuses at an item, by its line or its number.
[[noreturn]] void refuse_item(std::string_view source, const MissionItem& item, geom::Fault fault);

}  // namespace traj
