#include "roadmap/frontier.h"

#include <gtest/gtest.h>

#include <set>

#include "support/random_city.h"

namespace plan {
namespace {

struct Before {
  bool operator()(const Open& a, const Open& b) const { return a.before(b); }
};

// Whole numbers among them, so that all that can be equal sometimes is.
Open random_open(support::Random& random, double least, double span, std::uint32_t index) {
  Open open{};
  open.bound = least + (random.below(2) ? random.uniform(0, span) : random.stepped(0, span, 1));
  open.cost = random.stepped(0, 3, 1);
  open.index = index;
  open.kind = static_cast<Open::Kind>(random.below(3));
  return open;
}

// Against a sorted set: pushed and taken in turn, near and far, also before what was taken last.
TEST(Frontier, GivesThemInTheirOrder) {
  support::Random random(3);
  Frontier frontier;
  for (int round = 0; round < 60; ++round) {
    const double least = random.uniform(0, 1e4);
    const double width = random.uniform(1e-3, 5);
    const double span = random.uniform(1, 2000);
    frontier.start(least, width);
    std::set<Open, Before> expected;
    std::uint32_t index = 0;
    for (int step = 0; step < 400; ++step) {
      for (std::size_t n = random.below(6); n > 0; --n) {
        const Open open = random_open(random, least - 3, span, index++);
        frontier.push(open);
        expected.insert(open);
      }
      ASSERT_EQ(frontier.empty(), expected.empty());
      if (expected.empty()) continue;
      ASSERT_EQ(frontier.first().index, expected.begin()->index) << "round " << round;
      ASSERT_EQ(frontier.pop().index, expected.begin()->index);
      expected.erase(expected.begin());
    }
  }
}

TEST(Frontier, IsEmptyOnceItIsStartedAgain) {
  Frontier frontier;
  frontier.start(10, 1);
  for (const double bound : {1.0, 10.5, 12.0, 1e6}) frontier.push({bound, 0, 0, Open::reached});
  frontier.start(10, 1);
  EXPECT_TRUE(frontier.empty());
}

TEST(Open, TiesGoToTheLargerCostThenTheKindThenTheLowerIndex) {
  const Open open{1, 2, 3, Open::unlinked};
  EXPECT_TRUE((Open{0.5, 0, 9, Open::node}.before(open)));
  EXPECT_TRUE((Open{1, 3, 9, Open::node}.before(open)));
  EXPECT_TRUE((Open{1, 2, 9, Open::reached}.before(open)));
  EXPECT_TRUE((Open{1, 2, 2, Open::unlinked}.before(open)));
  EXPECT_FALSE(open.before(open));
}

}  // namespace
}  // namespace plan
