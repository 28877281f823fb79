#pragma once

// What the bounds of a map must be.

#include <string_view>

#include "geom/shape/aabb.h"

namespace geom {

// Throws InputError(source, …) unless the bounds are finite and have min < max on every axis.
void require_bounds(const Aabb& bounds, std::string_view source);

}  // namespace geom
