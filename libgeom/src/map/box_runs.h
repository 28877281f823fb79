#pragma once

// Boxes of one feature in the order in which they are made, and which of them stand in a region.

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "geom/shape/aabb.h"

namespace geom {

// Knows the bounds of each run of 16 boxes, of 256 and so on. What is made together lies together,
// so a question looks at few of them.
class BoxRuns {
 public:
  void add(std::span<const Aabb> boxes);

  // Those that may touch the region in plan and reach from its bottom or lower to its top or
  // higher; in their order.
  std::vector<Aabb> as_high_as(const Aabb& region) const;

  std::vector<Aabb> take() { return std::move(levels_.front()); }

 private:
  void look_up(const Aabb& region, std::size_t level, std::size_t first, std::size_t last,
               std::vector<Aabb>& out) const;

  std::vector<std::vector<Aabb>> levels_{
      1};  // the boxes, then the bounds of runs of the level before
};

// Whether the box reaches from the region's bottom or lower to its top or higher, and may touch it
// in plan.
inline bool is_as_high(const Aabb& box, const Aabb& region) {
  return box.min.z() <= region.min.z() && box.max.z() >= region.max.z() &&
         box.min.x() <= region.max.x() && box.max.x() >= region.min.x() &&
         box.min.y() <= region.max.y() && box.max.y() >= region.min.y();
}

}  // namespace geom
