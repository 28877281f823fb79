#pragma once

// Groups of points that are near to each other.

#include <cstddef>
#include <span>
#include <vector>

#include "geom/base/vec3.h"

namespace geom {

// Groups of points that are linked by steps of at most `tolerance` metres (> 0), as rounded doubles
// measure them: indices in ascending order, the largest group first, of equal ones that with the
// lowest index. The same for any number of points near each other: cubes in which all points are
// linked whatever their places are looked at as one, so time and memory grow with the points.
std::vector<std::vector<std::size_t>> clusters(std::span<const Vec3> points, double tolerance);

}  // namespace geom
