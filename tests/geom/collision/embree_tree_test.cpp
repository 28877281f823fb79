#include "collision/embree_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

#include "support/random_city.h"

namespace geom {
namespace {

// Goes through all nodes; each child must lie inside what its parent says of it.
struct Checked {
  std::vector<std::uint32_t> boxes;
  int depth = 0;
};

void check(const BuiltTree& built, std::span<const Aabb> boxes, std::uint32_t node, int depth,
           Checked& out) {
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

void expect_whole(std::span<const Aabb> boxes) {
  const BuiltTree built = embree_tree(boxes);
  Checked checked;
  check(built, boxes, 0, 1, checked);
  EXPECT_EQ(checked.boxes.size(), built.order.size());
  std::sort(checked.boxes.begin(), checked.boxes.end());
  ASSERT_EQ(checked.boxes.size(), boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) EXPECT_EQ(checked.boxes[i], i);
  EXPECT_LE(checked.depth, BoxTree::kMostDepth);
}

TEST(EmbreeTree, HoldsEveryBoxOnceInsideItsNodes) {
  for (const int count : {0, 1, 6, 14, 15, 16, 62, 500, 5000}) {
    expect_whole(support::random_city(3, count + 1, 600).boxes());
  }
}

TEST(EmbreeTree, TakesBoxesFromLeafToLeaf) {
  const auto city = support::random_city(3, 500, 600);
  const BuiltTree built = embree_tree(city.boxes());
  std::uint32_t next = 0;
  for (const BoxNode& node : built.tree.nodes) {
    for (const std::uint32_t child : node.child) {
      if (child == BoxNode::kNone || (child & BoxNode::kBox) == 0) continue;
      EXPECT_EQ(child & ~BoxNode::kBox, next++);
    }
  }
}

TEST(EmbreeTree, OfBoxesThatAreAllTheSameIsNotDeep) {
  expect_whole(std::vector<Aabb>(5000, Aabb{{1, 2, 3}, {4, 5, 6}}));
}

// Splits of least area take one box off at a time.
TEST(EmbreeTree, OfBoxesThatDoubleIsNotDeep) {
  std::vector<Aabb> boxes;
  for (int copy = 0; copy < 300; ++copy) {
    for (int k = 0; k < 16; ++k) {
      const double size = std::ldexp(1.0, k);
      boxes.push_back({{size, copy * 1e-6, 0}, {1.5 * size, size, size}});
    }
  }
  for (int k = -26; k < 30; ++k) {
    const double size = std::ldexp(1.0, k);
    boxes.push_back({{size, size, size}, {1.25 * size, 1.25 * size, 1.25 * size}});
  }
  expect_whole(boxes);
}

TEST(EmbreeTree, OfPointsIsATreeToo) {
  std::vector<Aabb> boxes;
  support::Random random(2);
  for (int i = 0; i < 100; ++i) {
    const Vec3 p(random.uniform(0, 1), 5, random.uniform(-1, 1));
    boxes.push_back({p, p});
  }
  expect_whole(boxes);
}

TEST(EmbreeTree, IsBuiltByManyThreadsAtOnce) {
  const auto city = support::random_city(5, 3000, 900);
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&, t] {
      const std::span<const Aabb> boxes = city.boxes();
      for (int i = 0; i < 20; ++i) {
        const BuiltTree built = embree_tree(boxes.subspan(static_cast<std::size_t>(100 * t), 1200));
        EXPECT_EQ(built.order.size(), 1200u);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
}

}  // namespace
}  // namespace geom
