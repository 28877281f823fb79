#include "traj/fleet/departure_span.h"

#include <gtest/gtest.h>

namespace traj {
namespace {

constexpr double kForEver = std::numeric_limits<double>::infinity();

TEST(DepartureSpan, HoldsItsEnds) {
  EXPECT_TRUE((DepartureSpan{1, 2}).holds(1));
  EXPECT_TRUE((DepartureSpan{1, 2}).holds(2));
  EXPECT_FALSE((DepartureSpan{1, 2}).holds(2.0000001));
  EXPECT_TRUE(DepartureSpan{}.holds(-1e300));
}

TEST(United, JoinsWhatTouchesAndKeepsTheRestInOrder) {
  using Spans = std::vector<DepartureSpan>;
  EXPECT_EQ(united({}), Spans{});
  EXPECT_EQ(united({{5, 6}, {1, 2}, {2, 3}}), (Spans{{1, 3}, {5, 6}}));
  EXPECT_EQ(united({{0, 10}, {2, 3}, {4, 12}}), (Spans{{0, 12}}));
  EXPECT_EQ(united({{3, kForEver}, {-kForEver, 1}, {1, 2}}),
            (Spans{{-kForEver, 2}, {3, kForEver}}));
}

}  // namespace
}  // namespace traj
