#include "together/ticks.h"

#include <gtest/gtest.h>

#include "support/random_city.h"

namespace traj {
namespace {

TEST(Ticks, AreExact) {
  support::Random random(1);
  for (int i = 0; i < 10000; ++i) {
    const double t =
        std::ldexp(random.uniform(0.5, 1), random.below(59) - 29) * (random.below(2) ? 1 : -1);
    EXPECT_EQ(seconds_of(ticks_of(t)), t);
  }
  EXPECT_TRUE(ticks_of(0) == 0);
  EXPECT_EQ(seconds_of(ticks_of(1e9)), 1e9);
  EXPECT_EQ(seconds_of(ticks_of(1e-9)), 1e-9);
}

TEST(Ticks, AddWithoutRounding) {
  EXPECT_TRUE(ticks_of(1e9) + ticks_of(1e-9) - ticks_of(1e9) == ticks_of(1e-9));
  EXPECT_TRUE(ticks_of(0.1) + ticks_of(0.2) != ticks_of(0.1 + 0.2));
}

TEST(Ticks, AreBetweenTheirBounds) {
  const Ticks t = ticks_of(0.1) + ticks_of(86400.3);
  EXPECT_LT(seconds_below(t), seconds_of(t));
  EXPECT_GT(seconds_above(t), seconds_of(t));
  EXPECT_TRUE(ticks_of(seconds_below(t)) < t && t < ticks_of(seconds_above(t)));
}

TEST(Ticks, HaveTheirLeastDoubleAbove) {
  EXPECT_EQ(seconds_not_below(ticks_of(0.1)), 0.1);
  EXPECT_EQ(seconds_not_below(0), 0);
  EXPECT_EQ(seconds_not_below(ticks_of(0.1) + 1), geom::next_up(0.1));
  EXPECT_EQ(seconds_not_below(ticks_of(0.1) - 1), 0.1);
  EXPECT_GT(seconds_not_below(1), 0);
  EXPECT_EQ(whole_time_below(1e-10), 0);
  EXPECT_EQ(whole_time_below(-1e-10), -1e-9);
  EXPECT_EQ(whole_time_below(-1e-9), -1e-9);
}

}  // namespace
}  // namespace traj
