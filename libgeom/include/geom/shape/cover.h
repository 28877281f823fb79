#pragma once

// Polygons as few axis-aligned rectangles.
//
// Example:
//   const geom::Polygon house{.outer = {{0, 0}, {8, 0}, {8, 6}, {0, 6}}};
//   assert(geom::cover(house, 0.5).size() == 1);  // a rectangle is covered by itself
//   const geom::Polygon wedge{.outer = {{0, 0}, {8, 0}, {0, 6}}};
//   assert(geom::cover(wedge, 0.5).size() > 4);  // slabs, none further than 0.5 m outside

#include <vector>

#include "geom/shape/polygon.h"

namespace geom {

struct Rectangle {  // closed; min <= max on both axes
  Vec2 min;
  Vec2 max;
};

// Rectangles that contain every point of the closed polygon. None of them reaches further than
// `slack` metres (> 0, Euclidean) outside the polygon. They are slabs along the axis that is
// expected to need fewer of them, each as wide as the slack allows. A polygon that fills the
// rectangle around it up to the slack gives that one rectangle, if its edges all run near the sides
// or it is a convex quadrilateral. A long convex quadrilateral that leans may give pieces of equal
// length. An axis-aligned rectangle gives one, a polygon of one point or line rectangles without
// extent. Rectangles are rounded outward by 1e-9 m and 4 units in the last place, which the slack
// includes; it must be at least 1e-6 m and 1e-9 of the coordinates (InputError otherwise). A
// polygon without points gives none. Cost: the number of slabs times that of the edges near each.
std::vector<Rectangle> cover(const Polygon& polygon, double slack);

}  // namespace geom
