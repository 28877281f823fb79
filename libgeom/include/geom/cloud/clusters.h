#pragma once

// Groups of points that are near to each other.
//
// Example:
//   const std::vector<geom::Vec3> points = {{0, 0, 0}, {9, 0, 0}, {0.4, 0, 0}};
//   const auto groups = geom::clusters(points, 0.5);
//   assert((groups[0] == std::vector<std::size_t>{0, 2}) && groups[1].size() == 1);

#include <cstddef>
#include <span>
#include <vector>

#include "geom/base/vec3.h"

namespace geom {

// Groups of points that are linked by steps of at most `tolerance` metres (> 0), as rounded doubles
// measure them: indices in ascending order, the largest group first, of equal ones that with the
// lowest index. Points in a cube so small that all of them are
// linked count as one, so time and memory grow with the number of points, however dense they are.
std::vector<std::vector<std::size_t>> clusters(std::span<const Vec3> points, double tolerance);

}  // namespace geom
