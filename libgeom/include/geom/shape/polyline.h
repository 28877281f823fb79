#pragma once

// A path: an ordered list of points joined by straight segments.
//
// Example:
//   const geom::Polyline way = {{0, 0, 5}, {10, 0, 5}, {10, 4, 5}};
//   assert(geom::length(way) == 14);
//   assert(geom::resample(way, 5).size() == 4);  // 5 + 5 + 4 m

#include <cstddef>
#include <vector>

#include "geom/base/vec3.h"

namespace geom {

using Polyline = std::vector<Vec3>;  // metres; a path has at least one point

// The sum of the segment lengths, in metres; 0 for fewer than two points.
double length(const Polyline& path);

// The same curve with every segment cut into the fewest equal parts of at most `step` metres
// (> 0). The original points stay, bit for bit. A cut point is rounded, so it may leave the
// segment by an ulp: check the parts again where that matters.
Polyline resample(const Polyline& path, double step);

}  // namespace geom
