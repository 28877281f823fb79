#pragma once

// Convex solids as stacks of rings: boxes, cylinders, spheres and what lies between; and the boxes
// that cover them, however they are turned.

#include <cstddef>
#include <vector>

#include "geom/shape/aabb.h"

namespace geom {

// The convex hull of its rings: polygons of `sides` corners each, in planes that are parallel and
// follow each other. Ring k has the corners from k * sides; corner i of a ring and corner i of the
// next are joined by an edge of the hull, or by a segment inside it.
struct RingStack {
  std::size_t sides = 0;
  std::vector<Vec3> corners;  // metres
};

// About (0, 0, 0), axes along x, y and z; those that are round lie wholly inside their stack, which
// reaches at most `error` metres (> 0) outside them. Sizes are >= 0. InputError where that takes
// more than 4,096 sides, of balls 128.
RingStack box_stack(const Vec3& size);
RingStack cylinder_stack(double radius, double length, double error);
RingStack cone_stack(double radius, double length, double error);  // its top at length / 2
RingStack ellipsoid_stack(const Vec3& radii, double error);
// A cylinder of that length with a half ball at either end.
RingStack capsule_stack(double radius, double length, double error);

// Boxes that contain every point of the solid, none of them reaching further than `slack` metres
// (> 0, Euclidean) outside it. Slabs across one axis, each as high as the slack allows, and in each
// the rectangles of cover() around what of the solid lies in it; the axis that needs the fewest.
// Rounded outward by about 1e-9 m, which the slack includes: it must be at least 1e-5 m and 1e-8
// of the coordinates. InputError where it is not, and where it takes more than 1,000,000 boxes.
std::vector<Aabb> cover(const RingStack& solid, double slack);

}  // namespace geom
