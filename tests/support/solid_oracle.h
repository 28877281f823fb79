#pragma once

// What is below a surface, tried point by point.

#include <algorithm>
#include <limits>
#include <vector>

#include "geom/base/vec3.h"
#include "geom/map/footprint.h"
#include "support/cover_oracle.h"
#include "support/random_city.h"

namespace oracle {

using geom::Vec3;

inline bool any_holds(const std::vector<geom::Aabb>& boxes, const Vec3& p) {
  return std::any_of(boxes.begin(), boxes.end(),
                     [&](const geom::Aabb& b) { return geom::contains(b, p); });
}

// Solid under the ring's corners, down to a height.
inline geom::Footprint solid_under(const std::vector<Vec3>& ring, double bottom = 0) {
  geom::Footprint f;
  f.bottom = bottom;
  f.top = ring.front().z();
  for (const Vec3& p : ring) {
    f.polygon.outer.push_back(p.head<2>());
    f.heights.push_back(p.z());
    f.top = std::max(f.top, p.z());
  }
  return f;
}

// Below a fan of triangles about the first corner, down to a height. The ring is convex in plan, or
// upright.
class SolidBelow {
 public:
  explicit SolidBelow(const geom::Footprint& f) : bottom_(f.bottom) {
    for (std::size_t i = 0; i < f.polygon.outer.size(); ++i) {
      const geom::Vec2& p = f.polygon.outer[i];
      ring_.push_back({p.x(), p.y(), f.heights.empty() ? f.top : f.heights[i]});
    }
  }

  // A random point on or below the surface.
  Vec3 point(support::Random& random) const {
    const std::size_t k =
        1 + static_cast<std::size_t>(random.below(static_cast<int>(ring_.size()) - 2));
    double u = random.uniform(0, 1);
    double v = random.uniform(0, 1);
    if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    Vec3 p = ring_[0] + u * (ring_[k] - ring_[0]) + v * (ring_[k + 1] - ring_[0]);
    if (random.uniform(0, 1) < 0.3) p.z() = random.uniform(bottom_, p.z());
    return p;
  }

  // No less than the distance from p to what is below, as it goes to points of it: those of a fine
  // grid over each triangle.
  double distance(const Vec3& p, int fine = 40) const {
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t k = 1; k + 1 < ring_.size(); ++k) {
      for (int i = 0; i <= fine; ++i) {
        for (int j = 0; i + j <= fine; ++j) {
          const Vec3 top =
              ring_[0] + (ring_[k] - ring_[0]) * i / fine + (ring_[k + 1] - ring_[0]) * j / fine;
          const Vec3 at(top.x(), top.y(), std::clamp(p.z(), bottom_, std::max(bottom_, top.z())));
          best = std::min(best, (at - p).norm());
        }
      }
    }
    return best;
  }

  // How far apart points of that grid are at most, half of it: what distance() may be too large by.
  double coarseness(int fine = 40) const {
    double most = 0;
    for (std::size_t k = 1; k + 1 < ring_.size(); ++k) {
      most = std::max({most, (ring_[k] - ring_[0]).norm(), (ring_[k + 1] - ring_[0]).norm(),
                       (ring_[k + 1] - ring_[k]).norm()});
    }
    return most / fine;
  }

 private:
  double bottom_;
  std::vector<Vec3> ring_;
};

}  // namespace oracle
