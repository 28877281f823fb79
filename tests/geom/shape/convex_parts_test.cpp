#include "shape/convex_parts.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/cover_oracle.h"
#include "support/random_city.h"

namespace geom {
namespace {

double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

double area(const std::vector<Vec2>& ring) {
  double twice = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) twice += turn(ring[0], ring[i], ring[i + 1]);
  return twice / 2;
}

double area(const std::vector<std::vector<Vec2>>& parts) {
  double sum = 0;
  for (const auto& part : parts) sum += area(part);
  return sum;
}

bool any_holds(const std::vector<std::vector<Vec2>>& parts, const Vec2& p) {
  return std::any_of(parts.begin(), parts.end(), [&](const auto& part) {
    return oracle::Distance({part, {}})(p.x(), p.y()) <= 1e-9;
  });
}

TEST(ConvexParts, LeaveAConvexRingWhole) {
  const auto parts = convex_parts({{{0, 0}, {0, 9}, {5, 12}, {9, 9}, {9, 0}, {0, 0}}, {}});
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(parts[0].size(), 5u);
  EXPECT_GT(area(parts), 0);
}

TEST(ConvexParts, AddUpToThePolygonWithItsHoles) {
  const Polygon frame = {{{0, 0}, {9, 0}, {9, 9}, {0, 9}},
                         {{{1, 1}, {4, 1}, {4, 4}, {1, 4}}, {{5, 5}, {8, 5}, {8, 8}, {5, 8}}}};
  const auto parts = convex_parts(frame);
  EXPECT_NEAR(area(parts), 81 - 18, 1e-9);
  for (const auto& part : parts) {
    for (std::size_t i = 0; i < part.size(); ++i) {
      EXPECT_GE(turn(part[i], part[(i + 1) % part.size()], part[(i + 2) % part.size()]), 0);
    }
  }
  EXPECT_FALSE(any_holds(parts, {2.5, 2.5}));
  EXPECT_FALSE(any_holds(parts, {6.5, 6.5}));
}

TEST(ConvexParts, OfALineAreItsEdges) {
  EXPECT_TRUE(any_holds(convex_parts({{{0, 0}, {5, 0}}, {}}), {2, 0}));
  EXPECT_TRUE(any_holds(convex_parts({{{0, 0}, {5, 0}, {2, 0}}, {}}), {4, 0}));
  EXPECT_TRUE(convex_parts({}).empty());
}

// Stars turn about all points that they hold; so do their crossings, whatever ears are cut.
TEST(ConvexParts, HoldEveryPointThatTheRingTurnsAbout) {
  support::Random random(21);
  for (int k = 0; k < 300; ++k) {
    const bool tangled = k % 3 == 0;
    Polygon polygon;
    const int n = 3 + static_cast<int>(random.uniform(0, 20));
    for (int i = 0; i < n; ++i) {
      const double angle = tangled ? random.uniform(0, 7) : 2 * M_PI * i / n;
      const double radius = random.uniform(3, 10);
      polygon.outer.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    if (!tangled) {
      polygon.holes = {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
      if (k % 2 == 0) std::reverse(polygon.holes[0].begin(), polygon.holes[0].end());
    }
    const auto parts = convex_parts(polygon);
    for (int i = 0; i < 200; ++i) {
      const Vec2 p(random.uniform(-10, 10), random.uniform(-10, 10));
      const bool inside = contains({polygon.outer, {}}, p) &&
                          !(polygon.holes.size() == 1 && contains({polygon.holes[0], {}}, p));
      if (inside) {
        EXPECT_TRUE(any_holds(parts, p)) << "case " << k << ": " << p.transpose();
      }
      if (!inside && !tangled) {
        EXPECT_LE(oracle::Distance(polygon)(p.x(), p.y()) > 1e-9 ? any_holds(parts, p) : 0, 0)
            << "case " << k << ": " << p.transpose();
      }
    }
  }
}

}  // namespace
}  // namespace geom
