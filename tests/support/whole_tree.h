#pragma once

// Whether a tree of the collision structure holds all boxes, each where its nodes say.

#include <gtest/gtest.h>

#include <algorithm>
#include <span>
#include <vector>

#include "collision/box_tree.h"

namespace support {

using geom::Aabb;
using geom::BoxNode;
using geom::BoxTree;
using geom::BuiltTree;

// Goes through all nodes; each child must lie inside what its parent says of it.
struct Checked {
  std::vector<std::uint32_t> boxes;
  int depth = 0;
};

inline void check(const BuiltTree& built, std::span<const Aabb> boxes, std::uint32_t node,
                  int depth, Checked& out) {
  out.depth = std::max(out.depth, depth);
  const BoxTree& tree = built.tree;
  const BoxNode& n = tree.nodes[node];
  for (std::size_t k = 0; k < BoxNode::kLanes; ++k) {
    if (n.child[k] == BoxNode::kNone) {
      EXPECT_GT(n.plane[0][k], n.plane[3][k]);
      continue;
    }
    if ((n.child[k] & BoxNode::kBox) != 0) {
      const std::uint32_t box = built.order[n.child[k] & ~BoxNode::kBox];
      out.boxes.push_back(box);
      for (int i = 0; i < 3; ++i) {
        EXPECT_LE(n.plane[i][k], boxes[box].min[i] - tree.frame.corner[i] - tree.frame.pad);
        EXPECT_GE(n.plane[i + 3][k], boxes[box].max[i] - tree.frame.corner[i] + tree.frame.pad);
      }
      continue;
    }
    const BoxNode& inner = tree.nodes[n.child[k]];
    for (std::size_t j = 0; j < BoxNode::kLanes; ++j) {
      if (inner.child[j] == BoxNode::kNone) continue;
      for (int i = 0; i < 3; ++i) {
        EXPECT_GE(inner.plane[i][j], n.plane[i][k]);
        EXPECT_LE(inner.plane[i + 3][j], n.plane[i + 3][k]);
      }
    }
    check(built, boxes, n.child[k], depth + 1, out);
  }
}

inline void expect_whole(const BuiltTree& built, std::span<const Aabb> boxes) {
  Checked checked;
  check(built, boxes, 0, 1, checked);
  EXPECT_EQ(checked.boxes.size(), built.order.size());
  std::sort(checked.boxes.begin(), checked.boxes.end());
  ASSERT_EQ(checked.boxes.size(), boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) EXPECT_EQ(checked.boxes[i], i);
  EXPECT_LE(checked.depth, BoxTree::kMostDepth);
}

}  // namespace support
