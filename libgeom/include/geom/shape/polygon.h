#pragma once

// Footprints: polygons in plan.
//
// Example:
//   const geom::Polygon yard{.outer = {{0, 0}, {9, 0}, {9, 9}, {0, 9}},
//                            .holes = {{{3, 3}, {6, 3}, {6, 6}, {3, 6}}}};
//   assert(geom::contains(yard, {1, 1}) && !geom::contains(yard, {4, 4}));
//   assert(geom::distance(yard, {12, 5}) == 3);

#include <Eigen/Core>
#include <vector>

namespace geom {

using Vec2 = Eigen::Vector2d;  // metres, x and y of the map's frame

// Rings of points, the last joined to the first (it may be repeated). The polygon is closed: a
// point is in it when it is on a ring, when it is within an odd number of rings, or when it is
// within `outer` (winding number not 0) and within no hole: so the rings' directions do not matter,
// and of rings that cross themselves nothing is left out.
struct Polygon {
  std::vector<Vec2> outer;
  std::vector<std::vector<Vec2>> holes;
};

// Whether the polygon contains p, in double precision: right for points off its edges; of a point
// on an edge, rounding decides.
bool contains(const Polygon& polygon, const Vec2& p);

// From p to the closed polygon, metres, to a few units in the last place; 0 inside.
double distance(const Polygon& polygon, const Vec2& p);

}  // namespace geom
