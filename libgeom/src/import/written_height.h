#pragma once

// Heights and storeys as people write them: read whole, or not at all.

#include <optional>
#include <string_view>

namespace geom {

// The largest and the smallest length, in metres, in text such as "12.13 m", "12,5", "40 ft 6 in",
// "100'-11\"", "~15", "3;4" or "30-40 m"; nothing where one part is not understood, as that might
// have been the one, or is not in [-1e4, 1e4]. Numbers before one with a unit are of that unit;
// where none is named, they are of `bare` metres. "1,250 ft" is read as thousands, "12,125 m" is
// not: where both readings are possible, no building is as high as 1000 m.
std::optional<double> parse_highest(std::string_view text, double bare = 1);
std::optional<double> parse_lowest(std::string_view text, double bare = 1);

// The same of storeys, in text such as "3", "L3.5", "-1", "2;4", "10-20 storeys", "3+2" (5, of
// which the lowest is not known) or "G+4" (5); within [-300, 300].
std::optional<double> parse_levels(std::string_view text);
std::optional<double> parse_lowest_level(std::string_view text);

}  // namespace geom
