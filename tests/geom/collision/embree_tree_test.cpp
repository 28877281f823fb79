#include "collision/embree_tree.h"

#include <gtest/gtest.h>

#include <thread>

#include "support/random_city.h"
#include "support/whole_tree.h"

namespace geom {
namespace {

void expect_whole(std::span<const Aabb> boxes) { support::expect_whole(embree_tree(boxes), boxes); }

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

TEST(EmbreeTree, HasFewNodesForItsBoxes) {
  const auto city = support::random_city(3, 5000, 3000);
  EXPECT_LT(embree_tree(city.boxes()).tree.nodes.size(), 5000u / 10);
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
