#pragma once

// Polygons cut into convex pieces.

#include <vector>

#include "geom/shape/polygon.h"

namespace geom {

// Convex rings, counter-clockwise, that together hold every point about which the rings of the
// polygon turn (once outward for `outer`, once back for each hole), and every point of their edges.
// That holds for any rings: the triangles that ears are cut from add up to the turns of the rings
// whatever their order. Those of a polygon whose rings do not cross do not overlap. By ears
// (Meisters, "Polygons have ears", 1975), each hole joined to the outer ring by a bridge; triangles
// that together are convex become one (Hertel and Mehlhorn, 1983). Doubles decide which ears are
// cut and what is convex, so a piece may be out of convexity by rounding. Cost: up to the square of
// the corners.
std::vector<std::vector<Vec2>> convex_parts(const Polygon& polygon);

}  // namespace geom
