#include "bound/tangent.h"

#include <gtest/gtest.h>

#include "plan/bound/random_labels.h"

namespace plan {
namespace {

constexpr double kSlack = 1e-12;

using testing::at;
using testing::best_over;
using testing::random_label;
using testing::random_part;

TEST(Tangent, IsNowhereAboveTheLeastSum) {
  support::Random random(1);
  for (int i = 0; i < 4000; ++i) {
    const double size = i % 2 ? 4 : 700;
    const EdgePart from = random_part(random, size);
    const EdgePart to = random_part(random, size);
    const Tangent between = tangent(from, to, kSlack);
    const LineLabel here = random_label(random, from);
    const LineLabel there = random_label(random, to);
    for (const double t : {0.0, 0.1, 0.35, 0.5, 0.8, 1.0}) {
      ASSERT_LE(at(between.forward(here), t), best_over(from, here, at(to, t), 200) + 1e-12);
      ASSERT_LE(at(between.backward(there), t), best_over(to, there, at(from, t), 200) + 1e-12);
    }
  }
}

TEST(Tangent, OfPlacesIsTheDistance) {
  const EdgePart a{{1, 2, 3}, {1, 2, 3}, kCorner, {}};
  const EdgePart b{{4, 6, 3}, {4, 6, 3}, kCorner, {}};
  const LineLabel by = tangent(a, b, kSlack).forward({7, 7});
  EXPECT_NEAR(by.low, 12, 1e-6);
  EXPECT_EQ(by.low, by.high);
  EXPECT_LE(by.low, 12);
  EXPECT_LE(tangent(a, a, kSlack).forward({7, 7}).low, 7);
}

TEST(Tangent, TouchesWhereTheWayIsBetweenMiddles) {
  const EdgePart a{{0, 0, -2}, {0, 0, 2}, 2, {1, 1}};
  const EdgePart b{{30, 40, -3}, {30, 40, 3}, 2, {1, 1}};
  const LineLabel by = tangent(a, b, kSlack).forward({5, 5});
  EXPECT_NEAR(by.low, 55, 1e-4);
  EXPECT_NEAR(by.high, 55, 1e-4);
}

TEST(Tangent, FollowsTheSlopeOfTheWay) {
  const EdgePart a{{0, 0, 0}, {0, 0, 0}, kCorner, {}};
  const EdgePart b{{3, 0, 3}, {3, 0, 5}, 2, {1, 1}};  // the middle is 5 away, 0.8 of it along z
  const LineLabel by = tangent(a, b, kSlack).forward({1, 1});
  EXPECT_NEAR(by.low, 6 - 0.8, 1e-5);
  EXPECT_NEAR(by.high, 6 + 0.8, 1e-5);
  const LineLabel back = tangent(a, b, kSlack).backward({1, 1});
  EXPECT_NEAR(back.low, 6 - 0.8, 1e-5);
}

}  // namespace
}  // namespace plan
