#include "collision/packed_tree.h"

#include <gtest/gtest.h>

#include "support/random_city.h"
#include "support/whole_tree.h"

namespace geom {
namespace {

std::vector<Aabb> squares(int side) {
  std::vector<Aabb> out;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const Vec3 low(300 * x, 300 * y, 0);
      out.push_back({low, low + Vec3(310, 310, 20 + (x * 7 + y * 3) % 50)});
    }
  }
  return out;
}

void expect_whole(std::span<const Aabb> boxes) { support::expect_whole(packed_tree(boxes), boxes); }

TEST(PackedTree, HoldsEveryBoxOnceInsideItsNodes) {
  for (const int side : {1, 2, 3, 4, 5, 16, 17, 33, 70}) expect_whole(squares(side));
  for (const int count : {15, 16, 17, 255, 256, 257, 4097}) {
    expect_whole(support::random_city(3, count, 600).boxes());
  }
}

TEST(PackedTree, HasFullNodes) {
  EXPECT_EQ(packed_tree(squares(16)).tree.nodes.size(), 17u);
  EXPECT_LT(packed_tree(squares(70)).tree.nodes.size(), 4900u / 14);
}

TEST(PackedTree, TakesWhatReachesOverMuchOfTheWholeIntoTheRoot) {
  for (const std::size_t wide : {1, 3, 8, 9, 40}) {
    std::vector<Aabb> boxes = squares(20);
    for (std::size_t i = 0; i < wide; ++i) boxes.push_back({{0, 0, 0}, {6000, 300, 30}});
    const BuiltTree built = packed_tree(boxes);
    support::expect_whole(built, boxes);
    std::size_t in_root = 0;
    for (const std::uint32_t child : built.tree.nodes.front().child) {
      if (child == BoxNode::kNone || (child & BoxNode::kBox) == 0) continue;
      EXPECT_GE(built.order[child & ~BoxNode::kBox], 400u);
      ++in_root;
    }
    EXPECT_EQ(in_root, wide <= 8 ? wide : 0);
  }
}

TEST(PackedTree, OfBoxesThatAreAllTheSameIsWhole) {
  expect_whole(std::vector<Aabb>(5000, Aabb{{1, 2, 3}, {4, 5, 6}}));
}

}  // namespace
}  // namespace geom
