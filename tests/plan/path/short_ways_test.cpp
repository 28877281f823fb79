#include "path/short_ways.h"

#include <gtest/gtest.h>

#include "support/random_city.h"

namespace plan {
namespace {

Vec3 random_place(support::Random& random, double low, double high) {
  Vec3 p;
  for (int k = 0; k < 3; ++k) p[k] = random.uniform(low, high);
  return p;
}

TEST(ShortWays, HoldWhatALineOfTwoLegsCanReach) {
  const ShortWays ways{{0, 0, 0}, {8, 0, 0}, 10};
  EXPECT_TRUE(ways.hold({4, 2.99, 0}));
  EXPECT_FALSE(ways.hold({4, 3.01, 0}));
  EXPECT_TRUE(ways.hold({8.99, 0, 0}));
  EXPECT_FALSE(ways.hold({-1.01, 0, 0}));
  const ShortWays none{{0, 0, 0}, {8, 0, 0}, 7};
  EXPECT_FALSE(none.hold({4, 0, 0}));
}

TEST(ShortWays, LieInTheBoxAroundThemAndMeetABoxThatHoldsOneOfTheirPlaces) {
  support::Random random(1);
  int held = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 from = random_place(random, -10, 10);
    const Vec3 to = random_place(random, -10, 10);
    const ShortWays ways{from, to, (to - from).norm() * random.uniform(1, 1.5)};
    const Vec3 p = random_place(random, -15, 15);
    if (!ways.hold(p)) continue;
    ++held;
    ASSERT_TRUE(geom::contains(geom::grow(ways.around(), Vec3::Constant(1e-9)), p)) << i;
    const Vec3 q = random_place(random, -15, 15);
    ASSERT_TRUE(ways.may_meet({p.cwiseMin(q), p.cwiseMax(q)})) << i;
  }
  EXPECT_GT(held, 500);
  const ShortWays ways{{0, 0, 0}, {8, 0, 0}, 10};
  EXPECT_FALSE(ways.may_meet({{4, 4, 4}, {5, 5, 5}}));
  EXPECT_NEAR((ways.around().max - Vec3(9, 3, 3)).norm(), 0, 1e-12);
}

}  // namespace
}  // namespace plan
