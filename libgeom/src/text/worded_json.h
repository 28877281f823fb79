#pragma once

// JSON text to values by nlohmann's parser, with words for what is wrong: parse_json's rules
// (geom/text/parse_json.h) are these.

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string_view>

namespace geom {

// As parse_json.
nlohmann::json worded_json(std::string_view text, std::string_view source, std::size_t line = 0);

// As parse_ordered_json.
nlohmann::ordered_json worded_ordered_json(std::string_view text, std::string_view source);

}  // namespace geom
