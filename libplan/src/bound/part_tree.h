#pragma once

// All parts of a map, to find those that a short path between two places can reach.

#include <cstdint>
#include <vector>

#include "convex_edges.h"
#include "median_tree.h"

namespace plan {

class PartTree {
 public:
  PartTree() = default;
  explicit PartTree(std::vector<EdgePart> parts);

  const std::vector<EdgePart>& parts() const { return parts_; }

  // The parts of which some point may be on a path from `from` to `to` of less than `length`
  // metres, by their least distances from both; numbers of parts(), in order.
  std::vector<std::uint32_t> within(const Vec3& from, const Vec3& to, double length) const;

 private:
  std::vector<EdgePart> parts_;
  MedianTree tree_;
};

}  // namespace plan
