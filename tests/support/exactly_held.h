#pragma once

// Whether points lie in boxes, in rational numbers.

#include <CGAL/number_utils.h>

#include <array>
#include <vector>

#include "geom/map/box_index.h"
#include "support/exact_oracle.h"

namespace oracle {

using ExactVec3 = std::array<Q, 3>;

inline ExactVec3 exact(const geom::Vec3& p) { return {Q(p.x()), Q(p.y()), Q(p.z())}; }

// The corners by whole weights whose sum is 2^20: a point of their triangle.
inline ExactVec3 weighted(const std::array<geom::Vec3, 3>& corners,
                          const std::array<int, 3>& weights) {
  ExactVec3 p;
  for (int k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < 3; ++i) {
      p[static_cast<std::size_t>(k)] += Q(corners[i][k]) * Q(weights[i]);
    }
    p[static_cast<std::size_t>(k)] /= Q(1 << 20);
  }
  return p;
}

// The boxes must outlive it.
class ExactlyHeld {
 public:
  explicit ExactlyHeld(const std::vector<geom::Aabb>& boxes)
      : boxes_(boxes), index_(boxes.empty() ? 1 : geom::index_cell(boxes)) {
    for (std::size_t i = 0; i < boxes.size(); ++i) index_.add(i, boxes[i]);
  }

  bool operator()(const ExactVec3& p) const {
    const geom::Vec3 near(CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2]));
    const geom::Vec3 reach = geom::Vec3::Constant(1e-9 + 1e-12 * near.cwiseAbs().maxCoeff());
    for (const std::size_t i : index_.near({near - reach, near + reach})) {
      bool in = true;
      for (int k = 0; k < 3 && in; ++k) {
        const Q& v = p[static_cast<std::size_t>(k)];
        in = Q(boxes_[i].min[k]) <= v && v <= Q(boxes_[i].max[k]);
      }
      if (in) return true;
    }
    return false;
  }

 private:
  const std::vector<geom::Aabb>& boxes_;
  geom::BoxIndex index_;
};

}  // namespace oracle
