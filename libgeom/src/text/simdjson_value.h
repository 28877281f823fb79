#pragma once

// JSON text to values by simdjson: several times faster than parse_json's own way, and without
// words for what is wrong.

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string_view>

namespace geom {

// What parse_json makes of the text, bit for bit, or nothing. Nothing says nothing of the text: it
// may be no JSON, break a rule of parse_json, be longer than kLongestForSimdjson or hold a number
// that simdjson does not keep. Whatever the processor, the answer is the same. May throw
// std::bad_alloc. Threads may call it at once.
std::optional<nlohmann::json> simdjson_value(std::string_view text);

// Bytes. What simdjson needs besides the value grows with the text, and records are far shorter.
inline constexpr std::size_t kLongestForSimdjson = std::size_t{1} << 24;

}  // namespace geom
