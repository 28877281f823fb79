#include "shape/cover_edge.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/random_city.h"

namespace geom {
namespace {

CoverEdge rising(const Vec2& low, const Vec2& high, int ring = 0, int turn = 1) {
  return {low, high, ring, turn};
}

TEST(CoverEdge, RangesOverItsPartInTheSlab) {
  const CoverEdge edge = rising({4, 0}, {0, 4});
  const auto expect = [&](double y0, double y1, double low, double high) {
    const Interval x = edge.range(y0, y1);
    EXPECT_EQ(x.low, low);
    EXPECT_EQ(x.high, high);
  };
  expect(1, 3, 1, 3);
  expect(-9, 9, 0, 4);
  expect(4, 5, 0, 0);
}

TEST(CoverEdge, OfOneLevelRangesOverAllOfIt) {
  const Interval x = rising({7, 2}, {3, 2}).range(2, 2);
  EXPECT_EQ(x.low, 3);
  EXPECT_EQ(x.high, 7);
}

TEST(CoverEdge, IsWithinWhatTheDistanceSays) {
  support::Random random(1);
  const auto any = [&] { return Vec2(random.uniform(-9, 9), random.uniform(-9, 9)); };
  for (int i = 0; i < 10000; ++i) {
    Vec2 low = any();
    Vec2 high = i % 10 == 0 ? low : any();
    if (low.y() > high.y()) std::swap(low, high);
    const CoverEdge edge = rising(low, high);
    const Vec2 p = any();
    const double distance = std::sqrt(edge.squared_distance(p));
    for (const double t : {0.0, 0.3, 0.7, 1.0}) {
      ASSERT_LE(distance, (low + t * (high - low) - p).norm() + 1e-12) << i;
    }
    const double reach = random.uniform(0, 9);
    if (std::abs(reach - distance) < 1e-9) continue;
    ASSERT_EQ(edge.is_within(reach * reach, p), distance < reach) << i;
  }
}

TEST(CoverEdge, IsRightOfWhatLiesLeftOfItBetweenItsEnds) {
  const CoverEdge edge = rising({0, 0}, {4, 4});
  EXPECT_TRUE(edge.is_right_of({1, 2}));
  EXPECT_FALSE(edge.is_right_of({3, 2}));
  EXPECT_FALSE(edge.is_right_of({2, 2}));  // on it
  EXPECT_TRUE(edge.is_right_of({-1, 0}));  // its lower end counts
  EXPECT_FALSE(edge.is_right_of({-1, 4}));
  EXPECT_TRUE(edge.is_right_of({std::nextafter(2.0, 0.0), 2}));
  EXPECT_FALSE(rising({0, 1}, {4, 1}).is_right_of({-1, 1}));
}

TEST(Outward, MovesASideByANanometreAndFourUnitsInTheLastPlace) {
  for (const double v : {0.0, 1.0, -3.7, 1e8, -1e8}) {
    EXPECT_EQ(outward(v, 1), v + (1e-9 + 4 * ulp(v)));
    EXPECT_EQ(outward(v, -1), v - (1e-9 + 4 * ulp(v)));
  }
}

TEST(Winding, IsInsideTheOuterRingAndOutsideEachHole) {
  Winding winding(3);
  EXPECT_FALSE(winding.inside());
  winding.count(rising({0, 0}, {0, 1}));
  EXPECT_TRUE(winding.inside());
  winding.count(rising({0, 0}, {0, 1}, 1, -1));
  EXPECT_FALSE(winding.inside());
  winding.count(rising({0, 0}, {0, 1}, 2, 1));
  winding.count(rising({0, 0}, {0, 1}, 1, 1));
  EXPECT_FALSE(winding.inside());
  winding.count(rising({0, 0}, {0, 1}, 2, -1));
  EXPECT_TRUE(winding.inside());
  winding.clear();
  EXPECT_FALSE(winding.inside());
}

}  // namespace
}  // namespace geom
