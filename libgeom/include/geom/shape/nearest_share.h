#pragma once

// Where a segment comes nearest to a box.
//
// Example:
//   assert(geom::nearest_share({0, 0, 0}, {10, 0, 0}, {{4, 2, 0}, {5, 3, 1}}) == 0.4);

#include "geom/shape/aabb.h"

namespace geom {

// The share of the way from `from` to `to`, 0 to 1, at which the closed segment is nearest to the
// closed box, to rounding; the first such place. Coordinates must be finite.
double nearest_share(const Vec3& from, const Vec3& to, const Aabb& box);

}  // namespace geom
