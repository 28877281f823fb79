#include "geom/shape/joined_outlines.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/random_city.h"

namespace geom {
namespace {

using Rings = std::vector<std::vector<Vec2>>;

double area(const Rings& rings) {
  double out = 0;
  for (const auto& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2& a = ring[i];
      const Vec2& b = ring[(i + 1) % ring.size()];
      out += 0.5 * (a.x() * b.y() - a.y() * b.x());
    }
  }
  return out;
}

// By the even-odd rule.
bool filled(const Rings& rings, const Vec2& p) {
  bool inside = false;
  for (const auto& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2& a = ring[i];
      const Vec2& b = ring[(i + 1) % ring.size()];
      if ((a.y() > p.y()) == (b.y() > p.y())) continue;
      if (p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
    }
  }
  return inside;
}

TEST(JoinedOutlines, AreRectanglesOfRectanglesApart) {
  const std::vector<Aabb> boxes = {{{0, 0, 0}, {2, 1, 1}}, {{5, 5, 0}, {6, 9, 1}}};
  const Rings rings = joined_outlines(boxes, {0.5, 0});
  ASSERT_EQ(rings.size(), 2u);
  EXPECT_EQ(rings[0], (std::vector<Vec2>{{0, 0}, {2, 0}, {2, 1}, {0, 1}}));
  EXPECT_EQ(area(rings), 6);
}

TEST(JoinedOutlines, GoAroundHolesTheOtherWay) {
  const std::vector<Aabb> ring = {{{0, 0, 0}, {9, 1, 1}},
                                  {{0, 8, 0}, {9, 9, 1}},
                                  {{0, 0, 0}, {1, 9, 1}},
                                  {{8, 0, 0}, {9, 9, 1}}};
  const Rings rings = joined_outlines(ring, {0.25, 0});
  ASSERT_EQ(rings.size(), 2u);
  EXPECT_EQ(area(rings), 81 - 49);
  EXPECT_FALSE(filled(rings, {4, 4}));
}

TEST(JoinedOutlines, StraightenStairsWithinTheTolerance) {
  std::vector<Aabb> stairs;
  for (int i = 0; i < 100; ++i) stairs.push_back({{i + 0.0, 0, 0}, {i + 1.0, 40 + 0.3 * i, 1}});
  EXPECT_GT(joined_outlines(stairs, {0.05, 0})[0].size(), 100u);
  EXPECT_LE(joined_outlines(stairs, {0.05, 1})[0].size(), 6u);
}

TEST(JoinedOutlines, DrawEvenWhatIsSmallerThanTheGrid) {
  const std::vector<Aabb> mast = {{{3.01, 3.01, 0}, {3.02, 3.02, 90}}};
  EXPECT_EQ(area(joined_outlines(mast, {0.5, 2})), 0.25);
  EXPECT_TRUE(joined_outlines({}, {}).empty());
}

TEST(JoinedOutlinesProperty, FillTheUnionOfBoxesOnTheGridAndNothingElse) {
  support::Random random(7);
  for (int round = 0; round < 40; ++round) {
    std::vector<Aabb> boxes;
    for (int i = random.below(40); i >= 0; --i) {
      const Vec3 low(random.below(80), random.below(80), 0);
      boxes.push_back({low, low + Vec3(1 + random.below(70), 1 + random.below(9), 1)});
    }
    const Rings rings = joined_outlines(boxes, {1, 0});
    double squares = 0;
    for (int x = 0; x < 160; ++x) {
      for (int y = 0; y < 100; ++y) {
        const Vec3 p(x + 0.5, y + 0.5, 0);
        const bool covered = std::any_of(boxes.begin(), boxes.end(), [&](const Aabb& b) {
          return b.min.x() < p.x() && p.x() < b.max.x() && b.min.y() < p.y() && p.y() < b.max.y();
        });
        squares += covered;
        ASSERT_EQ(filled(rings, p.head<2>()), covered)
            << "round " << round << " at " << x << ", " << y;
      }
    }
    ASSERT_EQ(area(rings), squares) << round;
  }
}

}  // namespace
}  // namespace geom
