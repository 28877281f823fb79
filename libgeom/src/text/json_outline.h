#pragma once

// The upper levels of a large JSON text, after all of it was checked by the rules of parse_json.

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string_view>

namespace geom {

// As parse_json, but lists and objects nested deeper than `depth` are empty in the value: memory
// for them is not kept. All their keys are checked, and a key that comes twice is refused.
nlohmann::json json_outline(std::string_view text, std::string_view source, std::size_t depth,
                            std::size_t line = 0);

}  // namespace geom
