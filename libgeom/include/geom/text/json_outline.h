#pragma once

// What a large JSON text says near its root, once all of it was read by the rules of parse_json.

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string_view>

namespace geom {

// As parse_json, but lists and objects nested deeper than `depth` are empty in the value: memory
// for them is not kept. Every key of theirs was looked at, and one that comes twice refused.
nlohmann::json json_outline(std::string_view text, std::string_view source, std::size_t depth,
                            std::size_t line = 0);

}  // namespace geom
