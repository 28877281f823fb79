#include "roadmap/bend_tree.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/random_city.h"

namespace plan {
namespace {

constexpr auto kAll = [](const BendTree::Node&) { return false; };  // nothing is skipped

// Some of them at the same place, far from the origin.
std::vector<Bend> random_bends(support::Random& random, std::size_t count) {
  std::vector<Bend> bends(count);
  for (Bend& bend : bends) {
    for (int k = 0; k < 3; ++k) {
      bend.position[k] =
          4e5 * k + (random.below(3) ? random.stepped(0, 20, 5) : random.uniform(0, 300));
    }
  }
  return bends;
}

// How often each bend of the leaves near `p` is met.
template <class Skip>
std::vector<int> met_near(const BendTree& tree, std::size_t bends, const Vec3& p, double radius,
                          const Skip& skip) {
  std::vector<int> met(bends);
  const auto pick = [&](std::uint32_t i) {
    unsigned out = 0;
    const BendTree::Node& node = tree.node(i);
    for (std::uint32_t k = 0; k < node.count; ++k) {
      const BendTree::Node& child = tree.node(node.first + k);
      const bool near = BendTree::squared_distance(child, p) <= radius * radius && !skip(child);
      out |= static_cast<unsigned>(near) << k;
    }
    return out;
  };
  tree.for_leaves(pick, [&](std::uint32_t first, std::uint32_t count) {
    for (std::uint32_t i = first; i < first + count; ++i) ++met[i];
  });
  return met;
}

Vec3 random_place(support::Random& random) {
  return {random.uniform(-50, 350), 4e5 + random.uniform(-50, 350), 8e5 + random.uniform(-50, 350)};
}

// The bends below a node, and whether each is no nearer to `p` than all boxes around it.
void expect_below(const BendTree& tree, std::uint32_t i, const std::vector<Bend>& bends,
                  const Vec3& p, double least, std::vector<int>& met) {
  const BendTree::Node& node = tree.node(i);
  least = std::max(least, BendTree::distance(tree.node(i), p));
  for (std::uint32_t k = node.first; k < node.first + node.count; ++k) {
    if (!node.leaf) {
      expect_below(tree, k, bends, p, least, met);
      continue;
    }
    ++met[k];
    ASSERT_LE(least, (p - bends[k].position).norm());
    ASSERT_LE(least, (bends[k].position - p).norm());
  }
}

TEST(BendTree, HasEachBendInOneLeafAndNoBoxFartherThanWhatIsInIt) {
  support::Random random(1);
  for (const std::size_t count : {1u, 15u, 16u, 17u, 33u, 2000u}) {
    const std::vector<Bend> bends = random_bends(random, count);
    const BendTree tree(bends);
    ASSERT_FALSE(tree.empty());
    for (int n = 0; n < 50; ++n) {
      const Vec3 p = n % 2 ? random_place(random) : bends[random.below(count)].position;
      std::vector<int> met(count);
      expect_below(tree, tree.root(), bends, p, 0, met);
      ASSERT_EQ(std::count(met.begin(), met.end(), 1), static_cast<std::ptrdiff_t>(count));
    }
  }
}

TEST(BendTree, FindsAllBendsWithinADistance) {
  support::Random random(2);
  const std::vector<Bend> bends = random_bends(random, 1500);
  const BendTree tree(bends);
  for (int n = 0; n < 200; ++n) {
    const Vec3 p = random_place(random);
    const double radius = random.uniform(0, 150);
    const auto met = met_near(tree, bends.size(), p, radius, kAll);
    for (std::size_t i = 0; i < bends.size(); ++i) {
      ASSERT_LE(met[i], 1);
      if ((bends[i].position - p).norm() <= radius) {
        ASSERT_EQ(met[i], 1) << i;
      }
    }
  }
}

TEST(BendTree, SkipsWhatIsBelowANode) {
  support::Random random(3);
  const std::vector<Bend> bends = random_bends(random, 1500);
  const BendTree tree(bends);
  const Vec3 p = random_place(random);
  const auto west = [&](const BendTree::Node& node) { return node.max[0] < p.x(); };
  const auto met = met_near(tree, bends.size(), p, 1e9, west);
  for (std::size_t i = 0; i < bends.size(); ++i) {
    if (bends[i].position.x() >= p.x()) {
      ASSERT_EQ(met[i], 1) << i;
    }
  }
  EXPECT_LT(std::count(met.begin(), met.end(), 1), 1500);
}

TEST(BendTree, OfNoBendsIsEmpty) {
  const BendTree tree({});
  EXPECT_TRUE(tree.empty());
  const auto all = [](std::uint32_t) { return 0xfu; };
  tree.for_leaves(all, [](std::uint32_t, std::uint32_t) { FAIL(); });
}

}  // namespace
}  // namespace plan
