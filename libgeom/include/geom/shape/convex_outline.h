#pragma once

// Convex hulls of points in plan.
//
// Example:
//   const auto hull = geom::convex_outline({{0, 0}, {4, 0}, {2, 1}, {4, 3}, {0, 3}});
//   assert(hull.size() == 4);  // (2, 1) lies inside

#include <vector>

#include "geom/shape/polygon.h"

namespace geom {

// The corners of the convex hull, counterclockwise, each once. They are fewer than three if the
// hull is a point or a line. In double precision: a corner that is within rounding of a side may be
// left out, which moves the side by a few ulp of the coordinates at most. O(n log n).
std::vector<Vec2> convex_outline(std::vector<Vec2> points);

}  // namespace geom
