#pragma once

// The height of a building from its attributes.
//
// Example:
//   const std::map<std::string, std::string> tags = {{"building:levels", "4"}};
//   const geom::BuildingHeight height = geom::building_height(
//       [&](const char* key) { return tags.contains(key) ? tags.at(key) : std::string(); }, {});
//   assert(height.top == 12 && height.from == geom::HeightFrom::levels);  // 3 m a storey

#include <functional>
#include <string>
#include <string_view>

namespace geom {

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
  bool tower = false;   // a tower, mast, chimney, crane or the like, which no default fits
  bool asked = false;   // options.attribute was there
};

// Whether a file's attribute `name` is the one called `key`: "HEIGHT" is "height".
bool is_attribute(std::string_view name, std::string_view key);

// Adds a value to those that an attribute has in a file, as in "3;50". building_height() takes of
// such a list what makes the building largest. Blank values are passed over.
void add_value(std::string_view value, std::string& list);

// From the higher of `height` and `building:height`; else the higher of `est_height` and of
// `building:levels` with roof:levels or roof:height; from `min_height` up, else from 0. Heights of
// 0 and below count as missing. A building whose bottom (`min_height`, or `building:min_level`
// storeys) is above its top is as high as both together, from 0. `tag` gives an attribute's text,
// empty where there is none.
BuildingHeight building_height(const std::function<std::string(const char*)>& tag,
                               const HeightOptions& options);

}  // namespace geom
