#pragma once

// How much of the box around some boxes lies in none of them.

#include <span>

#include "geom/shape/aabb.h"

namespace geom {

// A share of the volume, from 0 to below 1. Boxes count as 1 mm larger, so that rounding makes no
// gap. There is at least one box, and each has a volume.
double share_outside(std::span<const Aabb> boxes);

}  // namespace geom
