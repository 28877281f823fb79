#pragma once

// The returns of a flight in sentences.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "geom/map/box_map.h"
#include "traj/record/return_report.h"

namespace traj {

// "obstacle 7 (town hall)": the id in the source and the label.
std::string obstacle_in_words(const geom::BoxMap& map, std::optional<std::size_t> box);

// "while it climbs" of "climb".
std::string_view phase_in_words(std::string_view phase);

// From when to when no return is proved and why, for how much of the flight one is proved, and what
// to change. The report has a gap (precondition).
std::string returns_in_words(const ReturnReport& returns, const geom::BoxMap& map);

}  // namespace traj
