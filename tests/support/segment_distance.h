#pragma once

// The distance between a segment and a box by ternary search: slow and obviously right, the
// distance being convex.

#include "geom/shape/aabb.h"

namespace oracle {

inline double segment_distance(const geom::Vec3& a, const geom::Vec3& b, const geom::Aabb& box) {
  double low = 0;
  double high = 1;
  for (int i = 0; i < 200; ++i) {
    const double l = low + (high - low) / 3;
    const double h = high - (high - low) / 3;
    if (geom::distance(a + l * (b - a), box) < geom::distance(a + h * (b - a), box)) {
      high = h;
    } else {
      low = l;
    }
  }
  return geom::distance(a + low * (b - a), box);
}

}  // namespace oracle
