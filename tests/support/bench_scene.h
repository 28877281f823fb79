#pragma once

// What the benchmarks of collision run on: the city, random segments in it, and the yardstick.

#include <algorithm>
#include <utility>
#include <vector>

#include "geom/collision/collision.h"
#include "support/city.h"
#include "support/random_city.h"

namespace support {

using geom::Vec3;

inline const geom::CollisionScene& scene() {
  static const geom::CollisionScene one(load_city(city_file()), {"box", {1, 1, 1}}, 0);
  return one;
}

inline const std::vector<geom::Aabb>& grown_boxes() {
  static const auto made = [] {
    std::vector<geom::Aabb> list;
    for (std::size_t i = 0; i < scene().map().size(); ++i) list.push_back(scene().grown(i));
    return list;
  }();
  return made;
}

inline Vec3 random_point(Random& random) {
  const geom::Aabb& b = *scene().free_bounds();
  return {random.uniform(b.min[0], b.max[0]), random.uniform(b.min[1], b.max[1]),
          random.uniform(b.min[2], b.max[2])};
}

// Random segments of 5 to 50 m in every direction, anywhere inside the bounds.
inline const std::vector<std::pair<Vec3, Vec3>>& segments() {
  static const auto made = [] {
    Random random(1);
    std::vector<std::pair<Vec3, Vec3>> list;
    while (list.size() < 20000) {
      const Vec3 a = random_point(random);
      const Vec3 d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
      if (d.norm() > 1 || d.norm() < 0.1) continue;
      list.push_back({a, a + d.normalized() * random.uniform(5, 50)});
    }
    return list;
  }();
  return made;
}

// The textbook slab test (Kay and Kajiya 1986) in double.
inline bool slabs_hit(const Vec3& a, const Vec3& b, const geom::Aabb& box) {
  double first = 0;
  double last = 1;
  for (int i = 0; i < 3; ++i) {
    const double d = b[i] - a[i];
    if (d == 0) {
      if (a[i] < box.min[i] || a[i] > box.max[i]) return false;
      continue;
    }
    const double u = (box.min[i] - a[i]) / d;
    const double v = (box.max[i] - a[i]) / d;
    first = std::max(first, std::min(u, v));
    last = std::min(last, std::max(u, v));
    if (first > last) return false;
  }
  return true;
}

// What all targets scale by: one box after another, until one is hit.
inline bool brute_force(const Vec3& a, const Vec3& b) {
  const auto& boxes = grown_boxes();
  return std::any_of(boxes.begin(), boxes.end(),
                     [&](const geom::Aabb& box) { return slabs_hit(a, b, box); });
}

}  // namespace support
