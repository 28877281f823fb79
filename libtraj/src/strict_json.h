#pragma once

// JSON of drone files, where nothing may be passed over.

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace traj {

using DroneJson = nlohmann::ordered_json;

// The one value that `text` is. Throws geom::InputError(source, line, …) for text that is not JSON
// from its first byte to its last, for a key that an object says twice (readers differ in which
// counts), and for values nested deeper than 100.
DroneJson parse_strict_json(std::string_view text, std::string_view source);

// A value in a message: short, and never the insides of a list or an object.
std::string shown(const DroneJson& value);

}  // namespace traj
