#pragma once

// Where a search for the nearest of some boxes may begin: what an earlier one found nearby.

#include <atomic>
#include <cmath>
#include <cstdint>
#include <memory>

#include "geom/shape/aabb.h"

namespace geom {

// A box for each cell of a grid, none at first. Searches may read and set them from any thread: a
// hint bounds the radius, it never changes an answer.
class NearestHints {
 public:
  static constexpr std::uint32_t kNone = 0xffffffff;

  NearestHints() = default;

  // About as many cells as boxes, as near to cubes as that gives.
  NearestHints(const Aabb& extent, std::size_t boxes) : extent_(extent) {
    const Vec3 size = (extent.max - extent.min).cwiseMax(1.0);
    const double side = std::cbrt(size.prod() / static_cast<double>(boxes));
    cells_ = (size / side).array().ceil().cwiseMin(32).cast<int>();
    hint_ = std::make_unique<std::atomic<std::uint32_t>[]>(count());
    for (std::size_t i = 0; i < count(); ++i) hint_[i].store(kNone, std::memory_order_relaxed);
  }

  // Of the cell of a point, or of the one nearest to it.
  std::atomic<std::uint32_t>& at(const Vec3& p) const {
    std::size_t cell = 0;
    for (int i = 2; i >= 0; --i) {
      const double share = (p[i] - extent_.min[i]) / (extent_.max[i] - extent_.min[i]);
      // Not a number where the extent is flat.
      const int k = share > 0 ? static_cast<int>(std::min(share, 1.0) * (cells_[i] - 1e-9)) : 0;
      cell = cell * static_cast<std::size_t>(cells_[i]) + static_cast<std::size_t>(k);
    }
    return hint_[cell];
  }

  std::size_t bytes() const { return count() * sizeof(std::atomic<std::uint32_t>); }

 private:
  std::size_t count() const { return static_cast<std::size_t>(cells_.prod()); }

  Aabb extent_;
  Eigen::Vector3i cells_{0, 0, 0};
  std::unique_ptr<std::atomic<std::uint32_t>[]> hint_;
};

}  // namespace geom
