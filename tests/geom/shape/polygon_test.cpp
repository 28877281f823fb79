#include "geom/shape/polygon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/random_city.h"

namespace geom {
namespace {

std::vector<Vec2> square(double low, double high) {
  return {{low, low}, {high, low}, {high, high}, {low, high}};
}

std::vector<Vec2> backwards(std::vector<Vec2> ring) { return {ring.rbegin(), ring.rend()}; }

TEST(PolygonContains, IsInsideTheRingAndNotInTheHole) {
  const Polygon court{square(0, 10), {square(4, 6)}};
  EXPECT_TRUE(contains(court, {2, 5}));
  EXPECT_TRUE(contains(court, {9.999, 5}));
  EXPECT_TRUE(contains(court, {3.999, 5}));
  EXPECT_FALSE(contains(court, {4.001, 5}));
  EXPECT_FALSE(contains(court, {10.001, 5}));
}

TEST(PolygonContains, IsTheSameWhicheverWayTheRingsRunAndWhetherTheyAreClosed) {
  std::vector<Vec2> closed = square(0, 10);
  closed.push_back(closed.front());
  for (const Polygon& court :
       {Polygon{backwards(square(0, 10)), {square(4, 6)}},
        Polygon{square(0, 10), {backwards(square(4, 6))}}, Polygon{closed, {square(4, 6)}}}) {
    EXPECT_TRUE(contains(court, {2, 5}));
    EXPECT_FALSE(contains(court, {5, 5}));
    EXPECT_FALSE(contains(court, {-1, 5}));
    EXPECT_EQ(distance(court, {-2, 5}), 2);
  }
}

TEST(PolygonContains, LeavesNothingOutOfARingThatCrossesItself) {
  Polygon star;  // five points of a circle, every second joined: its middle is wound round twice
  for (int i = 0; i < 5; ++i) {
    star.outer.push_back({std::cos(i * 4 * M_PI / 5), std::sin(i * 4 * M_PI / 5)});
  }
  EXPECT_TRUE(contains(star, {0, 0}));
  EXPECT_TRUE(contains(star, {0.8, 0}));
  EXPECT_FALSE(contains(star, {-0.8, 0}));
  const Polygon island{square(0, 10), {square(2, 8), square(4, 6)}};
  EXPECT_TRUE(contains(island, {5, 5})) << "within three rings";
  EXPECT_FALSE(contains(island, {3, 5})) << "within two";
}

TEST(PolygonDistance, IsToTheNearestEdgeOrCornerAndZeroInside) {
  const Polygon court{square(0, 10), {square(4, 8)}};
  EXPECT_EQ(distance(court, {2, 5}), 0);
  EXPECT_EQ(distance(court, {13, 14}), 5);
  EXPECT_EQ(distance(court, {5, -2}), 2);
  EXPECT_EQ(distance(court, {6, 5}), 1) << "in the hole, to its edge";
}

// Against points along the edges, a thousand an edge.
TEST(PolygonDistance, IsThatOfTheNearestPointOfAnyEdge) {
  support::Random random(2);
  for (int round = 0; round < 60; ++round) {
    Polygon polygon;
    for (int i = 0; i < 3 + round % 6; ++i) {
      polygon.outer.push_back({random.uniform(-9, 9), random.uniform(-9, 9)});
    }
    for (int k = 0; k < 10; ++k) {
      const Vec2 p(random.uniform(-15, 15), random.uniform(-15, 15));
      double nearest = HUGE_VAL;
      for (std::size_t i = 0; i < polygon.outer.size(); ++i) {
        const Vec2 a = polygon.outer[i];
        const Vec2 b = polygon.outer[(i + 1) % polygon.outer.size()];
        for (int s = 0; s <= 1000; ++s)
          nearest = std::min(nearest, (a + (b - a) * (s / 1000.0) - p).norm());
      }
      const double expected = contains(polygon, p) ? 0 : nearest;
      ASSERT_NEAR(distance(polygon, p), expected, 0.02) << "seed 2, round " << round;
    }
  }
}

}  // namespace
}  // namespace geom
