#pragma once

// Boxes cut by a plane, and the convex chain around them over a base in it.

#include <algorithm>
#include <cmath>
#include <vector>

#include "geom/shape/aabb.h"

namespace plan {

using geom::Vec3;

// A point of the plane: along the base, and up from it.
struct Flat {
  double u;
  double w;
  Vec3 point;
};

// Calls f(p) where an edge of the box passes through the plane of `a` that is normal to the unit
// vector.
template <class F>
void for_edges_through(const geom::Aabb& box, const Vec3& a, const Vec3& normal, const F& f) {
  for (int k = 0; k < 3; ++k) {
    if (std::abs(normal[k]) < 1e-12) continue;  // its ends are those of edges across
    const int i1 = (k + 1) % 3;
    const int i2 = (k + 2) % 3;
    for (int corner = 0; corner < 4; ++corner) {
      Vec3 p = a;
      p[i1] = corner & 1 ? box.max[i1] : box.min[i1];
      p[i2] = corner & 2 ? box.max[i2] : box.min[i2];
      p[k] = a[k] - (normal[i1] * (p[i1] - a[i1]) + normal[i2] * (p[i2] - a[i2])) / normal[k];
      if (p[k] >= box.min[k] && p[k] <= box.max[k]) f(p);
    }
  }
}

// The upper convex chain of the points over the base from `first` to `last`, which are its ends
// (Andrew 1979).
inline std::vector<Flat> upper_chain(std::vector<Flat> points, const Flat& first,
                                     const Flat& last) {
  std::sort(points.begin(), points.end(),
            [](const Flat& x, const Flat& y) { return x.u != y.u ? x.u < y.u : x.w < y.w; });
  points.push_back(last);
  std::vector<Flat> hull = {first};
  for (const Flat& p : points) {
    while (hull.size() > 1) {
      const Flat& q = hull.back();
      const Flat& o = hull[hull.size() - 2];
      if ((q.u - o.u) * (p.w - o.w) - (q.w - o.w) * (p.u - o.u) < 0) break;
      hull.pop_back();
    }
    hull.push_back(p);
  }
  return hull;
}

}  // namespace plan
