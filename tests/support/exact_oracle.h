#pragma once

// Slow and obviously right: closed segments against closed boxes in exact rational arithmetic.

#include <CGAL/Gmpq.h>

#include "geom/shape/aabb.h"

namespace oracle {

using Q = CGAL::Gmpq;

// Whether the segment meets the box grown by `half`, all in rationals (slabs: no division by 0).
inline bool segment_hits(const geom::Vec3& a, const geom::Vec3& b, const geom::Aabb& box,
                         const geom::Vec3& half) {
  Q first = 0;
  Q last = 1;
  for (int i = 0; i < 3; ++i) {
    const Q low = Q(box.min[i]) - Q(half[i]);
    const Q high = Q(box.max[i]) + Q(half[i]);
    const Q d = Q(b[i]) - Q(a[i]);
    if (d == 0) {
      if (Q(a[i]) < low || Q(a[i]) > high) return false;
      continue;
    }
    Q u = (low - Q(a[i])) / d;
    Q v = (high - Q(a[i])) / d;
    if (u > v) std::swap(u, v);
    first = std::max(first, u);
    last = std::min(last, v);
    if (first > last) return false;
  }
  return true;
}

inline bool segment_hits(const geom::Vec3& a, const geom::Vec3& b, const geom::Aabb& box) {
  return segment_hits(a, b, box, geom::Vec3::Zero());
}

}  // namespace oracle
