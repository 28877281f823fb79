#pragma once

// Planes between a segment and a box.
//
// Example:
//   const geom::Aabb block{{4, 0, 0}, {5, 8, 8}};
//   const geom::Separation apart = geom::separation({1, 1, 1}, {1, 9, 1}, block);
//   assert(apart.gap == 3 && geom::behind(block, apart.plane));
//
// Where a coordinate of either is not finite or beyond kFarthest (geom/base/precondition.h), both
// functions that measure throw InputError.

#include "geom/shape/aabb.h"

namespace geom {

// The free side is normal.dot(x) <= offset; |normal| = 1 up to rounding.
struct Plane {
  Vec3 normal;
  double offset = 0;
};

// The plane between the segment and the closed box: through the box's point nearest to the segment
// and across the line to it, or, where that gap is below 1 mm, across the best of the six
// separating axes. Its offset is the box's own support, pulled in by min(1 mm, gap / 2), so that no
// rounding puts a point of the box on the free side. `gap` is the distance along the normal,
// before pulling in; <= 0 when the segment meets the box (the plane is then worthless).
struct Separation {
  Plane plane;
  double gap = 0;
};
Separation separation(const Vec3& from, const Vec3& to, const Aabb& box);

// Whether every point of the closed box is strictly off the free side.
bool behind(const Aabb& box, const Plane& plane);

// The distance between the closed segment and the closed box, metres; 0 where they meet.
double distance(const Vec3& from, const Vec3& to, const Aabb& box);

}  // namespace geom
