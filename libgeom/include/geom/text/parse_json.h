#pragma once

// JSON text to values: the one place that parses it.
//
// Example:
//   #include <nlohmann/json.hpp>
//   const nlohmann::json city = geom::parse_json(R"({"name":"Zurich","boxes":3})", "city.json");
//   assert(city["boxes"] == 3 && geom::shown(city["name"]) == "\"Zurich\"");
//   // A key that comes twice is refused: parse_json(R"({"a":1,"a":2})", "city.json") throws.
//
// What others' files may hold is refused here, before anybody looks at it: values nested deeper
// than kDeepestJson (reading, copying and writing them takes stack), a key that comes twice in an
// object (the later would silently win), numbers beyond what a double holds, anything after the
// value, and text that is no UTF-8. Each throws InputError with source, line and column, what was
// expected and what stood there.

#include <cstddef>
#include <iosfwd>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace geom {

// GeoJSON needs about 12, CityJSON and mission files as many.
inline constexpr std::size_t kDeepestJson = 100;

// `line`: where `text` stands in `source`, for the line of a stream of records; 0 where it is the
// whole source.
nlohmann::json parse_json(std::string_view text, std::string_view source, std::size_t line = 0);

// Parses all that is left of `in`. Throws std::system_error, too, if reading fails.
nlohmann::json parse_json(std::istream& in, std::string_view source);

// With the keys in the order of the text.
nlohmann::ordered_json parse_ordered_json(std::string_view text, std::string_view source);

// What stood there, for a message: the beginning of its JSON, printable.
std::string shown(const nlohmann::json& value);
std::string shown(const nlohmann::ordered_json& value);

}  // namespace geom
