#include "collision/filled_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "support/random_city.h"
#include "support/whole_tree.h"

namespace geom {
namespace {

std::size_t children(const BoxNode& node) {
  return static_cast<std::size_t>(
      std::count_if(node.child, node.child + BoxNode::kLanes,
                    [](std::uint32_t child) { return child != BoxNode::kNone; }));
}

// A chain: each node has some boxes and, but for the last, one node.
struct Chain {
  std::vector<Aabb> boxes;
  TreeFrame frame;
  std::vector<BoxNode> nodes;
};

void set(BoxNode& node, std::uint32_t child, const Aabb& box, const TreeFrame& frame) {
  const std::size_t k = children(node);
  node.child[k] = child;
  for (int i = 0; i < 3; ++i) {
    node.plane[i][k] = frame.low(box, i);
    node.plane[3 + i][k] = frame.high(box, i);
  }
}

Chain chain(support::Random& random, std::size_t links) {
  const auto city = support::random_city(7, static_cast<int>(15 * links), 500);
  Chain out{{city.boxes().begin(), city.boxes().end()}, TreeFrame(), {}};
  const Aabb all = *bounds(out.boxes);
  out.frame = TreeFrame(all);
  std::uint32_t box = 0;
  for (std::size_t link = 0; link < links; ++link) {
    BoxNode& node = out.nodes.emplace_back(empty_node());
    for (int count = 1 + random.below(15); count > 0; --count, ++box) {
      set(node, BoxNode::kBox | box, out.boxes[box], out.frame);
    }
    if (link + 1 < links) set(node, static_cast<std::uint32_t>(link + 1), all, out.frame);
  }
  out.boxes.resize(box);
  return out;
}

TEST(FilledTree, HasEachBoxOnceAndNoNodeThatCouldTakeInAnother) {
  support::Random random(5);
  for (int i = 0; i < 100; ++i) {
    const Chain made = chain(random, static_cast<std::size_t>(1 + random.below(12)));
    const BuiltTree filled = filled_tree(made.frame, made.nodes, made.boxes.size());
    support::expect_whole(filled, made.boxes);
    EXPECT_LE(filled.tree.nodes.size(), made.nodes.size());
    for (const BoxNode& node : filled.tree.nodes) {
      for (const std::uint32_t child : node.child) {
        if ((child & BoxNode::kBox) != 0) continue;
        EXPECT_GT(children(node) - 1 + children(filled.tree.nodes[child]), BoxNode::kLanes);
      }
    }
  }
}

TEST(FilledTree, OfALostBoxIsAFault) {
  support::Random random(6);
  const Chain made = chain(random, 3);
  EXPECT_THROW(filled_tree(made.frame, made.nodes, made.boxes.size() + 1), std::logic_error);
}

}  // namespace
}  // namespace geom
