#pragma once

// What the user of an imported flight should know of it.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "traj/mission/ulog/px4_flight.h"

namespace importing {

// Throws geom::InputError where no position of the log can be used, with the reason.
void require_positions(const traj::Px4Flight& flight, const std::string& source, bool placed);

// What may be wrong: a log that breaks off, what was left out, lost messages, steps of the
// estimate, heights of another zero. A sentence each. `geoid`: what heights above the sea were
// converted with; nothing where none were.
std::vector<std::string> warnings(const traj::Px4Flight& flight, std::optional<double> geoid);

// Where the coordinates and the time count from, in a sentence.
// `origin`: "the map's origin"; empty where none was given.
std::string told(const traj::Px4Flight& flight, std::string_view origin, std::string_view begin);

nlohmann::ordered_json stats(const traj::Px4Flight& flight);  // for --stats

}  // namespace importing
