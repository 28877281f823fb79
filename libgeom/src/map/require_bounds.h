#pragma once

// What the bounds and the boxes of a map must be.

#include <string_view>

#include "geom/map/box_table.h"
#include "geom/shape/aabb.h"

namespace geom {

// Throws InputError(source, …) unless the bounds are finite and have min < max on every axis.
void require_bounds(const Aabb& bounds, std::string_view source);

// Whether no coordinate is beyond kLargestCoordinate: no reader of maps takes a box that reaches
// further.
bool is_within_reach(const Aabb& box);

// Throws InputError(source, …) unless all boxes are within reach.
void require_within_reach(const BoxTable& table, std::string_view source);

}  // namespace geom
