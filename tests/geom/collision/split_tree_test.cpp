#include "collision/split_tree.h"

#include <gtest/gtest.h>

#include <thread>

#include "support/random_city.h"
#include "support/whole_tree.h"

namespace geom {
namespace {

void expect_whole(std::span<const Aabb> boxes) { support::expect_whole(split_tree(boxes), boxes); }

TEST(SplitTree, HoldsEveryBoxOnceInsideItsNodes) {
  for (const int count : {0, 1, 6, 14, 15, 16, 62, 500, 5000}) {
    expect_whole(support::random_city(3, count + 1, 600).boxes());
  }
}

TEST(SplitTree, TakesBoxesFromLeafToLeaf) {
  const auto city = support::random_city(3, 500, 600);
  const BuiltTree built = split_tree(city.boxes());
  std::uint32_t next = 0;
  for (const BoxNode& node : built.tree.nodes) {
    for (const std::uint32_t child : node.child) {
      if (child == BoxNode::kNone || (child & BoxNode::kBox) == 0) continue;
      EXPECT_EQ(child & ~BoxNode::kBox, next++);
    }
  }
}

TEST(SplitTree, HasFewNodesForItsBoxes) {
  const auto city = support::random_city(3, 5000, 3000);
  EXPECT_LT(split_tree(city.boxes()).tree.nodes.size(), 5000u / 10);
}

TEST(SplitTree, OfBoxesThatAreAllTheSameIsNotDeep) {
  const std::vector<Aabb> boxes(5000, Aabb{{1, 2, 3}, {4, 5, 6}});
  support::Checked checked;
  support::check(split_tree(boxes), boxes, 0, 1, checked);
  EXPECT_LE(checked.depth, 5)
      << "16 to the power of 4 are more than 5000, and leaves need not be full";
  expect_whole(boxes);
}

// Splits of least area take one box off at a time.
TEST(SplitTree, OfBoxesThatDoubleIsNotDeep) {
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

TEST(SplitTree, OfPointsIsATreeToo) {
  std::vector<Aabb> boxes;
  support::Random random(2);
  for (int i = 0; i < 100; ++i) {
    const Vec3 p(random.uniform(0, 1), 5, random.uniform(-1, 1));
    boxes.push_back({p, p});
  }
  expect_whole(boxes);
}

TEST(SplitTree, IsBuiltByManyThreadsAtOnce) {
  const auto city = support::random_city(5, 3000, 900);
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&, t] {
      const std::span<const Aabb> boxes = city.boxes();
      for (int i = 0; i < 20; ++i) {
        const BuiltTree built = split_tree(boxes.subspan(static_cast<std::size_t>(100 * t), 1200));
        EXPECT_EQ(built.order.size(), 1200u);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
}

}  // namespace
}  // namespace geom
