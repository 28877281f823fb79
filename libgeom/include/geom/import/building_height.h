#pragma once

// Heights as people write them into building attributes.

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace geom {

// A length in metres from text such as "12.13 m", "12,5", "40 ft", "40'", "7'4\"" or "~15"; nothing
// where no such number leads it, or it is not in [-1e4, 1e4]. A number that names no unit is of
// `bare` metres.
std::optional<double> parse_length(std::string_view text, double bare = 1);

// The largest and the smallest length in text such as "3;4" or "30-40 m". The largest passes over
// parts that are none; the smallest is nothing where one is, as that might have been smaller.
std::optional<double> parse_highest(std::string_view text, double bare = 1);
std::optional<double> parse_lowest(std::string_view text, double bare = 1);

// The same of storeys, in text such as "3", "L3.5", "-1", "2;4" or "3-5"; within [-300, 300].
std::optional<double> parse_levels(std::string_view text);
std::optional<double> parse_lowest_level(std::string_view text);

struct HeightOptions {
  std::string attribute;       // looked at before the usual ones; may be empty
  double storey = 3;           // metres
  double default_height = 10;  // metres, where nothing tells
  double unit = 1;             // metres that a number without a unit stands for
};

enum class HeightFrom { height, levels, nothing };

struct BuildingHeight {
  double bottom = 0;  // metres above the ground
  double top = 0;     // > bottom
  HeightFrom from = HeightFrom::nothing;
  bool junk = false;    // an attribute of height was there and could not be understood
  bool unread = false;  // and it might have said that the building is higher than `top`
  bool bare = false;    // a number without a unit was taken
};

// From `height`, `building:height`, `building:levels` (and roof:levels, roof:height where the
// height is counted by storeys), `min_height` and `building:min_level`. `tag` gives an attribute's
// text, empty where there is none.
BuildingHeight building_height(const std::function<std::string(const char*)>& tag,
                               const HeightOptions& options);

}  // namespace geom
