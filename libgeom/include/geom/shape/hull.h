#pragma once

// Convex hulls of a few points against boxes.
//
// Example:
//   const std::vector<geom::Vec3> triangle = {{0, 0, 5}, {10, 0, 5}, {0, 10, 5}};
//   assert(geom::hull_meets(triangle, {{1, 1, 0}, {2, 2, 8}}));
//   assert(!geom::hull_meets(triangle, {{8, 8, 0}, {9, 9, 8}}));
//
// Where a coordinate is not finite or beyond kFarthest (geom/base/precondition.h), InputError.

#include <optional>
#include <span>

#include "geom/shape/aabb.h"

namespace geom {

// A point where the closed convex hull of the points (at least one) meets the closed box, or
// nothing if they are apart. They count as apart only if a plane separates them after its rounding
// is subtracted, so those nearer than about 1e-14 of the coordinates may count as meeting.
//
// Wolfe, "Finding the nearest point in a polytope" (1976), on the hull of all differences of a
// point and a corner. Cost: a few passes over the points.
std::optional<Vec3> hull_meets(std::span<const Vec3> points, const Aabb& box);

// How deep the hull reaches into the box, metres: the most that all six faces of the box can move
// inwards until the two are apart, to 1e-7; and a point of the hull that is as deep. Both must meet
// (else 0, and the first point). For reports only, not for a verdict.
struct HullDepth {
  double depth = 0;
  Vec3 place = Vec3::Zero();
};
HullDepth hull_depth(std::span<const Vec3> points, const Aabb& box);

}  // namespace geom
