#include "bound/median_tree.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "geom/base/random.h"

namespace plan {
namespace {

using geom::Vec3;

std::vector<geom::Aabb> random_boxes(std::size_t count) {
  geom::SplitMix64 random(count);
  std::vector<geom::Aabb> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = random.uniform(0, 100);
    const double y = random.uniform(0, 30);
    const Vec3 low(x, y, random.uniform(0, 10));
    boxes.push_back({low, low + Vec3(1, 2, 3)});
  }
  return boxes;
}

// Which boxes lie below a node, each of whose boxes must hold them.
void add_below(const MedianTree& tree, std::uint32_t node, std::span<const geom::Aabb> boxes,
               std::vector<std::uint32_t>& below) {
  const MedianTree::Node& n = tree.nodes[node];
  const std::size_t before = below.size();
  if (n.count == 0) {
    add_below(tree, n.begin, boxes, below);
    add_below(tree, n.begin + 1, boxes, below);
  } else {
    EXPECT_LE(n.count, 4u);
    below.insert(below.end(), tree.order.begin() + n.begin, tree.order.begin() + n.begin + n.count);
  }
  for (std::size_t i = before; i < below.size(); ++i) {
    EXPECT_TRUE(geom::contains(n.box, boxes[below[i]].min));
    EXPECT_TRUE(geom::contains(n.box, boxes[below[i]].max));
  }
}

TEST(MedianTree, HasEachBoxOnceBelowNodesThatHoldIt) {
  for (const std::size_t count : {1, 2, 4, 5, 77, 1000}) {
    const auto boxes = random_boxes(count);
    const MedianTree tree(boxes, 4);
    std::vector<std::uint32_t> below;
    add_below(tree, 0, boxes, below);
    EXPECT_EQ(below, tree.order);
    std::sort(below.begin(), below.end());
    for (std::uint32_t i = 0; i < count; ++i) EXPECT_EQ(below[i], i);
    EXPECT_EQ(below.size(), count);
  }
}

TEST(MedianTree, OfNoBoxesHasNoNodes) { EXPECT_TRUE(MedianTree({}, 4).nodes.empty()); }

// As many alike as a walk with a stack of 128 must bear.
TEST(MedianTree, HalvesBoxesThatAreAlike) {
  const std::vector<geom::Aabb> boxes(1000, {Vec3::Zero(), Vec3::Ones()});
  const MedianTree tree(boxes, 4);
  EXPECT_LT(tree.nodes.size(), 1000u);
}

}  // namespace
}  // namespace plan
