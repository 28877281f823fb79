#pragma once

// All parts of a map, to find those that a short path between two places can reach.

#include <cstdint>
#include <vector>

#include "convex_edges.h"
#include "geom/shape/aabb.h"

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
  struct Node {
    geom::Aabb box;
    std::uint32_t begin = 0;  // of the order, of a leaf; else the first of two children
    std::uint32_t count = 0;  // 0: not a leaf
  };

  void build(std::uint32_t node, std::uint32_t begin, std::uint32_t end);

  std::vector<EdgePart> parts_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace plan
