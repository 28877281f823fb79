#pragma once

// Default lengths for searches: those that suit a city, and smaller ones on smaller maps.
//
// Example:
//   const geom::Aabb room{{0, 0, 0}, {30, 20, 10}};
//   assert(plan::fitting_length(room, 15) == 1.5);  // 15 m in a city of 300 m

#include "geom/shape/aabb.h"

namespace plan {

inline constexpr double kCity = 300;  // metres

// `in_a_city` metres where the longest side of `free_bounds` is at least kCity; else the same share
// of that side. A step of 15 m is one of 0.42 m in a room of 8.4 m. `in_a_city` where all sides are
// 0.
double fitting_length(const geom::Aabb& free_bounds, double in_a_city);

}  // namespace plan
