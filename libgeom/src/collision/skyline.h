#pragma once

// A first look at a segment: whether it stays above everything around it.

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

#include "geom/shape/aabb.h"

namespace geom {

// The highest top of the boxes over each cell of a grid in plan. Cells are found by the same
// monotone arithmetic for boxes and queries, so a box that a segment meets shares a cell with it.
class Skyline {
 public:
  Skyline() = default;
  Skyline(std::span<const Aabb> boxes, const Aabb& extent)
      : low_(extent.min.x(), extent.min.y()),
        per_metre_(kSide / std::max(1.0, (extent.max - extent.min).head<2>().maxCoeff())),
        tops_(kSide * kSide, -std::numeric_limits<double>::infinity()) {
    for (const Aabb& box : boxes) {
      const int x1 = cell(box.max.x(), 0);
      const int y1 = cell(box.max.y(), 1);
      for (int y = cell(box.min.y(), 1); y <= y1; ++y) {
        for (int x = cell(box.min.x(), 0); x <= x1; ++x) {
          double& top = tops_[static_cast<std::size_t>(y * kSide + x)];
          top = std::max(top, box.max.z());
        }
      }
    }
  }

  // Whether the whole segment is surely above all boxes; false where that takes a long look.
  bool clears(const Vec3& a, const Vec3& b) const {
    const double z = std::min(a.z(), b.z());
    const int x0 = cell(std::min(a.x(), b.x()), 0);
    const int x1 = cell(std::max(a.x(), b.x()), 0);
    const int y0 = cell(std::min(a.y(), b.y()), 1);
    const int y1 = cell(std::max(a.y(), b.y()), 1);
    if ((x1 - x0 + 1) * (y1 - y0 + 1) > kMostCells) return false;
    for (int y = y0; y <= y1; ++y) {
      const double* const row = &tops_[static_cast<std::size_t>(y * kSide)];
      for (int x = x0; x <= x1; ++x) {
        if (!(row[x] < z)) return false;
      }
    }
    return true;
  }

  bool clears(const Vec3& p) const {
    return tops_[static_cast<std::size_t>(cell(p.y(), 1) * kSide + cell(p.x(), 0))] < p.z();
  }

  std::size_t bytes() const { return tops_.size() * sizeof(double); }

 private:
  static constexpr int kSide = 64;
  static constexpr int kMostCells = 48;

  int cell(double v, int axis) const {  // in the order that takes what is not a number to 0
    return static_cast<int>(std::max(0.0, std::min(kSide - 1.0, (v - low_[axis]) * per_metre_)));
  }

  Eigen::Vector2d low_;
  double per_metre_ = 1;
  std::vector<double> tops_;
};

}  // namespace geom
