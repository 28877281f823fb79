#pragma once

// A binary tree over boxes, halved at the median of their middles along the longest side.

#include <cstdint>
#include <span>
#include <vector>

#include "geom/shape/aabb.h"

namespace plan {

struct MedianTree {
  struct Node {
    geom::Aabb box;           // around all below
    std::uint32_t begin = 0;  // of a leaf: in `order`; else the first of two children
    std::uint32_t count = 0;  // 0: not a leaf
  };

  std::vector<Node> nodes;           // the root first; none without boxes
  std::vector<std::uint32_t> order;  // numbers of boxes, leaf after leaf

  MedianTree() = default;
  // Of middles that are alike, the box of the lower number comes first.
  MedianTree(std::span<const geom::Aabb> boxes, std::uint32_t most_in_a_leaf);
};

}  // namespace plan
