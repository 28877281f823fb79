#include "collision/group_tree.h"

#include <gtest/gtest.h>

#include <numeric>

#include "collision/embree_tree.h"
#include "support/random_city.h"

namespace geom {
namespace {

struct Parts {
  BoxMap city = support::random_city(4, 700, 500);
  BuiltTree built = embree_tree(city.boxes());
  std::vector<std::uint32_t> names;

  Parts() : names(city.size()) { std::iota(names.rbegin(), names.rend(), 5u); }
};

bool same(const Aabb& x, const Aabb& y) { return x.min == y.min && x.max == y.max; }

void expect_laid_out(const Parts& p, const GroupTree& tree, std::span<const Aabb> by_vehicle) {
  EXPECT_EQ(tree.first, 77u);
  EXPECT_EQ(tree.frame.corner, p.built.tree.frame.corner);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(tree.nodes()) % alignof(BoxNode), 0u);
  for (std::size_t i = 0; i < p.built.tree.nodes.size(); ++i) {
    const BoxNode& node = p.built.tree.nodes[i];
    for (std::size_t k = 0; k < BoxNode::kLanes; ++k) {
      ASSERT_EQ(tree.nodes()[i].child[k], node.child[k]);
      for (int plane = 0; plane < 6; ++plane) {
        ASSERT_EQ(tree.nodes()[i].plane[plane][k], node.plane[plane][k]);
      }
    }
  }
  for (std::size_t i = 0; i < p.built.order.size(); ++i) {
    const std::uint32_t k = p.built.order[i];
    ASSERT_TRUE(same(tree.grown[i], p.city.boxes()[k]));
    ASSERT_TRUE(same(tree.by_vehicle[i], by_vehicle[k]));
    ASSERT_EQ(tree.name[i], p.names[k]);
  }
  EXPECT_EQ(tree.count, p.city.size());
  EXPECT_GT(tree.bytes, p.city.size() * (sizeof(Aabb) + sizeof(std::uint32_t)));
}

TEST(GroupTree, HasTheBoxesInTheOrderOfTheLeaves) {
  const Parts p;
  const OwnedGroup tree = group_tree({p.built, p.city.boxes(), {}, p.names, 77, nullptr}, nullptr);
  expect_laid_out(p, *tree, p.city.boxes());
  EXPECT_EQ(tree->by_vehicle, tree->grown);
}

TEST(GroupTree, HasThoseWithoutTheMarginBesides) {
  const Parts p;
  std::vector<Aabb> smaller(p.city.boxes().begin(), p.city.boxes().end());
  for (Aabb& box : smaller) box.max = box.min;
  const OwnedGroup tree =
      group_tree({p.built, p.city.boxes(), smaller, p.names, 77, nullptr}, nullptr);
  expect_laid_out(p, *tree, smaller);
}

// As do the first looks of a map that is one group, which end with it.
TEST(GroupTree, MayLieInAnArena) {
  const Parts p;
  HugeArena arena;
  for (int i = 0; i < 20; ++i) {
    const Aabb extent = *bounds(p.city.boxes());
    std::unique_ptr<FirstLooks> looks(
        new FirstLooks{NearestHints(extent, 100), Skyline(p.city.boxes(), extent)});
    const OwnedGroup tree =
        group_tree({p.built, p.city.boxes(), {}, p.names, 77, std::move(looks)}, &arena);
    expect_laid_out(p, *tree, p.city.boxes());
    EXPECT_TRUE(tree->in_arena);
    EXPECT_TRUE(tree->looks);
  }
}

}  // namespace
}  // namespace geom
