#pragma once

// What the user of a flight from a PX4 log should know of it.
//
// Example, not run:
//   std::ifstream file("log.ulg", std::ios::binary);
//   const traj::Px4Flight flight = traj::read_px4_flight(file, "log.ulg", {});
//   for (const std::string& text : traj::warnings(flight, {})) std::cerr << text << '\n';

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "traj/mission/ulog/px4_flight.h"

namespace traj {

// Throws geom::InputError where no position of the log can be used, with the reason.
void require_positions(const Px4Flight& flight, const std::string& source, bool placed);

// What may be wrong: a log that breaks off, what was left out, lost messages, steps of the
// estimate, heights of another zero. A sentence each. `geoid`: what heights above the sea were
// converted with; nothing where none were.
std::vector<std::string> warnings(const Px4Flight& flight, std::optional<double> geoid);

// Where the coordinates and the time count from, in a sentence.
// `origin`: "the map's origin"; empty where none was given.
std::string told(const Px4Flight& flight, std::string_view origin, std::string_view begin);

// Counts and times, as --stats of skyway-import-flight writes them.
nlohmann::ordered_json stats(const Px4Flight& flight);

}  // namespace traj
