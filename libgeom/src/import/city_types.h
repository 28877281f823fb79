#pragma once

// Which objects of a city model are built, by their types.

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "geom/import/city_model.h"

namespace geom {

// Objects that are left out, by their types.
struct LeftOutTypes {
  std::map<std::string, std::size_t> count;
  double rise = 0;  // metres: how far the highest of them is above the lowest ground
};

// Marks what is left out. With `types`: all but objects of these types and their parts. Without:
// roads, land use and the like (kFlat) where they lie on the ground, at most kFlatRise above its
// lowest point; nothing where no other object would be left. `unit`: metres in one of the model's
// heights.
LeftOutTypes leave_out(CityModel& model, const std::vector<std::string>& types, double unit);

// How many objects there are of each type.
std::map<std::string, std::size_t> types_of(const CityModel& model);

}  // namespace geom
