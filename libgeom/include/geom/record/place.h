#pragma once

// Places as people give them: metres of a map, or latitude, longitude and height.
//
// Example:
//   const auto place = geom::parse_place("60.1719N,24.9414E,2above");
//   assert(std::get<geom::EarthPlace>(*place).above);
//   assert(std::get<geom::Vec3>(*geom::parse_place("12.5,30,5")).y() == 30);

#include <optional>
#include <string_view>
#include <variant>

#include "geom/base/vec3.h"

namespace geom {

struct EarthPlace {
  double latitude = 0;   // degrees, WGS 84
  double longitude = 0;  // degrees
  double height = 0;     // metres above the map's zero
  bool above = false;    // … above the highest box under the place, else above the map's floor

  friend bool operator==(const EarthPlace&, const EarthPlace&) = default;
};

using Place = std::variant<Vec3, EarthPlace>;

// What parse_place() takes, for messages.
inline constexpr std::string_view kPlaceForms =
    "x,y,z in metres, as one word such as 12.5,30,5, or degrees and a height such as "
    "60.1719N,24.9414E,30 or 60.1719N,24.9414E,2above";

// Three fields between commas. Letters make a place geographic: N or S, and E or W, in either
// order. Nothing for other text: a latitude beyond 90 degrees, a longitude beyond 180, a minus
// before a letter, a number that is not finite or beyond kLargestCoordinate.
std::optional<Place> parse_place(std::string_view text);

// A height by itself, as in "30" or "2above", and whether it is above what stands there.
struct Height {
  double metres = 0;
  bool above = false;
};
std::optional<Height> parse_height(std::string_view text);

}  // namespace geom
