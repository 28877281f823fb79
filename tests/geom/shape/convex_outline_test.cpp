#include "geom/shape/convex_outline.h"

#include <gtest/gtest.h>

#include <random>

namespace geom {
namespace {

TEST(ConvexOutline, OfFewPointsIsThem) {
  EXPECT_TRUE(convex_outline({}).empty());
  EXPECT_EQ(convex_outline({{1, 2}, {1, 2}}).size(), 1u);
  EXPECT_EQ(convex_outline({{1, 2}, {0, 0}, {1, 2}}).size(), 2u);
}

TEST(ConvexOutline, GoesRoundTheCorners) {
  const auto outline = convex_outline({{0, 0}, {1, 1}, {2, 0}, {2, 2}, {0, 2}, {1, 0}, {2, 2}});
  EXPECT_EQ(outline, (std::vector<Vec2>{{0, 0}, {2, 0}, {2, 2}, {0, 2}}));
  EXPECT_EQ(convex_outline({{0, 0}, {1, 1}, {2, 2}}).size(), 2u);
}

TEST(ConvexOutline, HoldsEveryPoint) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> place(-5, 5);
  for (int k = 0; k < 300; ++k) {
    std::vector<Vec2> points(3 + random() % 60);
    for (Vec2& p : points) p = {place(random), k % 2 ? place(random) : std::round(place(random))};
    const Polygon outline{convex_outline(points), {}};
    for (const Vec2& p : points) ASSERT_LE(distance(outline, p), 1e-14) << "case " << k;
  }
}

}  // namespace
}  // namespace geom
