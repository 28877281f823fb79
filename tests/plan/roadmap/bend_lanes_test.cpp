#include "roadmap/bend_lanes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/random_city.h"

namespace plan {
namespace {

std::int8_t random_sign(support::Random& random) { return random.below(2) ? 1 : -1; }

// Often in line with each other.
Bend random_bend(support::Random& random) {
  Bend bend;
  for (int k = 0; k < 3; ++k) {
    bend.position[k] = random.below(2) ? random.stepped(0, 20, 5) : random.uniform(0, 20);
  }
  bend.axis = static_cast<std::int8_t>(random.below(3));
  bend.outward = {random_sign(random), random_sign(random)};
  return bend;
}

// What a path that came to `bend` from `in` may go on to, one bend at a time.
bool goes_on(const Bend& bend, const Across& in, const Bend& other) {
  const Vec3 d = other.position - bend.position;
  const Across out = across(bend, d);
  if (out.second_side() == in.second_side() || !out.tangent()) return false;
  if (!across(other, -d).tangent()) return false;
  const double sum = std::abs(out.x) + std::abs(out.y);
  const double turn = out.second_side() ? std::abs(out.y) - (in.ratio() - kLoose) * sum
                                        : (in.ratio() + kLoose) * sum - std::abs(out.y);
  return turn >= -1e-9;
}

TEST(BendLanes, AreReachedAsBendsAreOneByOne) {
  support::Random random(1);
  int reached = 0;
  int too_far = 0;  // from the goal
  for (int n = 0; n < 20'000; ++n) {
    std::vector<Bend> bends(BendTree::kBendsOfLeaf + 3);
    for (Bend& bend : bends) bend = random_bend(random);
    const Bend from = random_bend(random);
    const Across in = across(from, random_bend(random).position - from.position);
    const Onward onward(from, in);
    const std::size_t count = 1 + static_cast<std::size_t>(random.below(BendTree::kBendsOfLeaf));
    const double reach = random.below(2) ? 100 : 400;  // squared
    const Look look{from.position, onward, reach, random.uniform(0, 60)};
    const Vec3 goal = 2 * random_bend(random).position;
    std::vector<double> to_goal;
    for (const Bend& bend : bends) to_goal.push_back((goal - bend.position).norm());
    to_goal.resize(bends.size() + BendTree::kChildren);
    double squares[BendTree::kBendsOfLeaf];
    const BendLanes lanes(bends);
    const unsigned alone = lanes.one_by_one(3, count, look, to_goal.data(), squares);
    const unsigned mask = lanes.reached(3, count, look, to_goal.data(), squares);
    ASSERT_EQ(mask, alone);
    ASSERT_EQ(mask >> count, 0u);
    for (std::size_t k = 0; k < count; ++k) {
      const Bend& other = bends[3 + k];
      ASSERT_EQ(squares[k], (other.position - from.position).squaredNorm());
      const bool near = squares[k] <= reach && goes_on(from, in, other);
      const double over = std::sqrt(squares[k]) + to_goal[3 + k] - look.left;
      if (std::abs(over) < 2 * BendLanes::kSpare) continue;
      ASSERT_EQ((mask >> k & 1) != 0, near && over < 0);
      reached += near && over < 0;
      too_far += near && over > 0;
    }
  }
  EXPECT_GT(reached, 1000);
  EXPECT_GT(too_far, 1000);
}

TEST(BendLanes, LookIntoTheSameNodesAsOneByOne) {
  support::Random random(2);
  int into = 0;
  int past = 0;
  for (int n = 0; n < 300; ++n) {
    std::vector<Bend> bends(17 + static_cast<std::size_t>(random.below(500)));
    Vec3 leaf = Vec3::Zero();
    for (std::size_t i = 0; i < bends.size(); ++i) {
      if (i % BendTree::kBendsOfLeaf == 0) leaf = 5 * random_bend(random).position;
      bends[i] = random_bend(random);
      bends[i].position += leaf;
    }
    const BendTree tree(bends);
    const Bend from = bends[random.below(bends.size())];
    const Onward onward(from, across(from, random_bend(random).position - from.position));
    const Look look{from.position, onward, random.uniform(0, 2000), random.uniform(20, 200)};
    const Vec3 goal = 5 * random_bend(random).position;
    std::vector<double> to_goal;
    for (std::uint32_t i = 0; i < tree.size(); ++i) {
      to_goal.push_back(BendTree::distance(tree.node(i), goal));
    }
    to_goal.resize(tree.size() + BendTree::kChildren);
    for (std::uint32_t i = 0; i < tree.size(); ++i) {
      if (tree.node(i).leaf) continue;
      const unsigned mask = BendLanes::reached(tree, i, look, to_goal.data());
      ASSERT_EQ(mask, BendLanes::one_by_one(tree, i, look, to_goal.data()));
      ASSERT_EQ(mask >> tree.node(i).count, 0u);
      into += mask != 0;
      past += mask == 0;
    }
  }
  EXPECT_GT(into, 500);
  EXPECT_GT(past, 500);
}

}  // namespace
}  // namespace plan
