#include "geom/shape/cover.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "support/cover_oracle.h"
#include "support/exact_cover.h"
#include "support/random_city.h"

namespace geom {
namespace {

Polygon rotated_rectangle(double width, double height, double angle, const Vec2& center) {
  Polygon out;
  const Eigen::Rotation2Dd turn(angle);
  for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
    out.outer.push_back(center + turn * Vec2(0.5 * x * width, 0.5 * y * height));
  }
  return out;
}

Polygon star(support::Random& random, const Vec2& center, int corners, double radius) {
  Polygon out;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * M_PI * i / corners;
    const double r = random.uniform(0.2, 1) * radius;
    out.outer.push_back(center + r * Vec2(std::cos(angle), std::sin(angle)));
  }
  return out;
}

// Anything: corners at random, so edges cross.
Polygon tangle(support::Random& random, int corners) {
  Polygon out;
  for (int i = 0; i < corners; ++i) {
    out.outer.push_back({random.stepped(0, 20, 1), random.stepped(0, 20, 1)});
  }
  return out;
}

void expect_cover(const Polygon& polygon, double slack, support::Random& random,
                  const std::string& what, double loose = 1e-4) {
  const auto rectangles = cover(polygon, slack);
  Vec2 low = polygon.outer.front();
  Vec2 high = low;
  const auto ring = [&](const std::vector<Vec2>& points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec2& a = points[i];
      const Vec2& b = points[(i + 1) % points.size()];
      low = low.cwiseMin(a);
      high = high.cwiseMax(a);
      ASSERT_TRUE(oracle::covered(rectangles, a)) << what << ": a corner";
      for (const double t : {0.5, 0.1, random.uniform(0, 1)}) {
        ASSERT_TRUE(oracle::covered(rectangles, a + t * (b - a))) << what << ": on an edge";
      }
    }
  };
  ring(polygon.outer);
  for (const auto& hole : polygon.holes) ring(hole);
  const oracle::Distance distance(polygon);
  for (int i = 0; i < 300; ++i) {
    const Vec2 p(random.uniform(low.x(), high.x()), random.uniform(low.y(), high.y()));
    if (distance(p.x(), p.y()) > 0) continue;
    ASSERT_TRUE(oracle::covered(rectangles, p)) << what << ": inside, " << p.transpose();
  }
  ASSERT_TRUE(oracle::exactly_covered(polygon, rectangles)) << what;
  for (const Rectangle& r : rectangles) {
    ASSERT_LE(oracle::furthest_outside(polygon, r, loose * slack, slack), slack * (1 + 2 * loose))
        << what;
  }
}

TEST(Cover, IsOneForAnAlignedRectangle) {
  EXPECT_EQ(cover(rotated_rectangle(80, 35, 0, {3, 4}), 0.5).size(), 1u);
}

TEST(Cover, IsTwoForAnL) {
  const Polygon l{{{0, 0}, {30, 0}, {30, 10}, {10, 10}, {10, 50}, {0, 50}}, {}};
  EXPECT_EQ(cover(l, 0.5).size(), 2u);
}

TEST(Cover, KeepsACourtyardOpen) {
  Polygon block = rotated_rectangle(40, 40, 0, {0, 0});
  block.holes.push_back(rotated_rectangle(20, 20, 0, {0, 0}).outer);
  const auto rectangles = cover(block, 0.5);
  EXPECT_EQ(rectangles.size(), 4u);
  EXPECT_FALSE(oracle::covered(rectangles, {0, 0}));
  EXPECT_FALSE(oracle::covered(rectangles, {9.4, 9.4}));
}

// Teeth that stand side by side, the last of which leans: slabs across all of them are many times
// as many as slabs along them.
Polygon comb(int teeth, bool level) {
  Polygon out;
  out.outer.push_back({0, -3});
  out.outer.push_back({4.0 * teeth + 30, -3});
  out.outer.push_back({4.0 * teeth + 30, 60});
  for (int i = teeth; i-- > 0;) {
    for (const Vec2& p : {Vec2(3, 0), Vec2(2, 0), Vec2(2, 60), Vec2(0, 60)}) {
      out.outer.push_back(p + Vec2(4.0 * i, 0));
    }
    out.outer.push_back({4.0 * i, 0});
  }
  if (!level) return out;
  for (Vec2& p : out.outer) std::swap(p.x(), p.y());
  return out;
}

TEST(Cover, GoesAlongTheAxisThatNeedsFewer) {
  for (const int teeth : {8, 50, 2000}) {
    const std::size_t most = static_cast<std::size_t>(2 * teeth) + 150;
    EXPECT_LT(cover(comb(teeth, false), 0.5).size(), most) << teeth;
    EXPECT_LT(cover(comb(teeth, true), 0.5).size(), most) << teeth;
  }
}

TEST(Cover, OfRotatedRectanglesHoldsAll) {
  support::Random random(1);
  for (int i = 0; i < 60; ++i) {
    const double offset = i % 3 == 0 ? 4e5 : 0;
    const Polygon p = rotated_rectangle(random.uniform(0.5, 40), random.uniform(0.5, 40),
                                        random.uniform(0, M_PI), {offset, -offset});
    expect_cover(p, random.uniform(0.2, 2), random, "rotated " + std::to_string(i));
  }
}

// The distance to a convex polygon is largest at a corner, so this is exact up to long doubles.
TEST(Cover, StaysWithinTheLeastSlackOfLargeCoordinates) {
  support::Random random(5);
  for (int i = 0; i < 300; ++i) {
    const double size = std::pow(10, random.uniform(0, 7));
    const double slack = std::max(1e-6, 1e-9 * size) * random.uniform(1, 3);
    const double turn = random.uniform(0.1, 1.4);
    const Vec2 along = slack * random.uniform(20, 60) * Vec2(std::cos(turn), std::sin(turn));
    const Vec2 aside = random.uniform(0.2, 1) * Vec2(-along.y(), along.x());
    const Vec2 corner = 0.9 * size * Vec2(1, random.uniform(-1, 1));
    const Polygon polygon{{corner, corner + along, corner + along + aside, corner + aside}, {}};
    const oracle::Distance distance(polygon);
    for (const Rectangle& r : cover(polygon, slack)) {
      for (const double x : {r.min.x(), r.max.x()}) {
        for (const double y : {r.min.y(), r.max.y()}) {
          ASSERT_LE(distance(x, y), static_cast<long double>(slack)) << "case " << i;
        }
      }
    }
  }
}

TEST(Cover, OfStarsWithHolesHoldsAll) {
  support::Random random(2);
  for (int i = 0; i < 60; ++i) {
    Polygon p = star(random, {0, 0}, 3 + i % 20, 30);
    if (i % 2) p.holes.push_back(star(random, {0, 0}, 5, 5).outer);
    if (i % 4 == 1) std::reverse(p.holes[0].begin(), p.holes[0].end());
    expect_cover(p, 0.5, random, "star " + std::to_string(i));
  }
}

TEST(Cover, OfRingsThatCrossThemselvesHoldsAll) {
  support::Random random(3);
  for (int i = 0; i < 100; ++i) {
    expect_cover(tangle(random, 3 + i % 9), 0.5, random, "tangle " + std::to_string(i));
  }
}

Polygon regular(int corners, double radius) {
  Polygon out;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * M_PI * i / corners;
    out.outer.push_back(radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return out;
}

// The furthest points of these lie on long lines, where the oracle would look at all of them.
TEST(Cover, OfSliversSpursAndRepeatedPointsHoldsAll) {
  support::Random random(4);
  for (int i = 0; i < 40; ++i) {
    const double angle = random.uniform(0, M_PI);
    expect_cover(rotated_rectangle(40, random.uniform(1e-9, 0.01), angle, {7, 5}), 0.5, random,
                 "sliver " + std::to_string(i), 0.02);
  }
  const Vec2 tip(30, 12.3);
  const Polygon spur{{{0, 0}, {10, 0}, {10, 5}, tip, {10, 5}, {10, 10}, {10, 10}, {0, 10}}, {}};
  expect_cover(spur, 0.5, random, "spur", 0.02);
  const Polygon level{{{0, 0}, {10, 0}, {10, 5}, {40, 5}, {10, 5}, {10, 10}, {0, 10}}, {}};
  expect_cover(level, 0.5, random, "level spur", 0.02);
  Polygon outside{rotated_rectangle(10, 10, 0.3, {0, 0}).outer, {}};
  outside.holes.push_back(rotated_rectangle(10, 4, 1.1, {6, 2}).outer);
  expect_cover(outside, 0.5, random, "a hole that reaches outside", 0.02);
}

TEST(Cover, OfManyCornersEnds) {
  EXPECT_LT(cover(regular(20000, 500), 0.5).size(), 2100u);
  support::Random random(5);
  Polygon knot;
  for (int i = 0; i < 100; ++i) {
    knot.outer.push_back({random.uniform(0, 100), random.uniform(0, 100)});
  }
  EXPECT_LT(cover(knot, 0.5).size(), 2000u);
}

TEST(Cover, OfPointsAndLinesHasNoExtentToSpeakOf) {
  const auto point = cover({{{3, 4}}, {}}, 0.5);
  ASSERT_EQ(point.size(), 1u);
  EXPECT_LT((point[0].max - point[0].min).maxCoeff(), 1e-8);
  const auto line = cover({{{3, 4}, {30, 4}}, {}}, 0.5);
  ASSERT_EQ(line.size(), 1u);
  EXPECT_LT(line[0].max.y() - line[0].min.y(), 1e-8);
  EXPECT_TRUE(cover({}, 0.5).empty());
}

// What leans by less than the slack is one rectangle, whatever corners its sides have.
TEST(Cover, AStripThatLeansLittleIsOneRectangle) {
  support::Random random(5);
  for (int i = 0; i < 40; ++i) {
    const double width = random.uniform(2, 300);
    const double height = random.uniform(2, 300);
    const double most = 0.5 / std::hypot(width, height);  // of the slack 0.5, in radians
    const double angle = random.uniform(-1, 1) * most;
    Polygon strip = rotated_rectangle(width, height, angle, {1e4, -3e4});
    std::vector<Vec2> fine;
    for (std::size_t k = 0; k < 4; ++k) {
      for (int part = 0; part < 7; ++part) {
        fine.push_back(strip.outer[k] + part / 7.0 * (strip.outer[(k + 1) % 4] - strip.outer[k]));
      }
    }
    strip.outer = fine;
    EXPECT_EQ(cover(strip, 0.51).size(), 1u) << i;
    expect_cover(strip, 0.51, random, "strip " + std::to_string(i));
  }
}

// As rows of a raster do on the plane of another projection.
// The corners of the rectangle around it are 0.42 m from a square whose sides each lean by as much.
TEST(Cover, ASquareThatLeansIsOneRectangleUpToTheSlack) {
  const Polygon square = rotated_rectangle(24, 24, 0.0175, {50, 80});
  const double away = 24 * std::sin(0.0175) * std::cos(0.0175);
  support::Random random(6);
  for (const double more : {1e-6, 0.1}) {
    EXPECT_EQ(cover(square, away + more).size(), 1u);
    expect_cover(square, away + more, random, "square");
  }
  EXPECT_GT(cover(square, away - 1e-6).size(), 1u);
}

TEST(Cover, ALongStripThatLeansIsAPieceForEachSlackThatItRises) {
  support::Random random(7);
  for (const bool upright : {false, true}) {
    for (const double angle : {0.02, -0.013}) {
      Polygon strip = rotated_rectangle(200, 9, angle, {1e4, -3e4});
      if (upright) {
        for (Vec2& p : strip.outer) p = {p.y(), p.x()};
      }
      const double rise = 200 * std::abs(std::sin(angle));
      EXPECT_LE(cover(strip, 0.5).size(), static_cast<std::size_t>(rise / 0.5) + 3);
      expect_cover(strip, 0.5, random, "long strip", 1e-3);
    }
  }
}

// A polygon along the sides of its rectangle alone, which is hollow.
TEST(Cover, AFrameAroundNothingIsNotOneRectangle) {
  const Polygon ring{{{0, 0},
                      {20, 0},
                      {20, 20},
                      {0, 20},
                      {0, 0.2},
                      {0.2, 0.2},
                      {0.2, 19.8},
                      {19.8, 19.8},
                      {19.8, 0.1},
                      {0, 0.1}},
                     {}};
  EXPECT_GT(cover(ring, 0.5).size(), 1u);
  support::Random random(6);
  expect_cover(ring, 0.5, random, "frame");
}

}  // namespace
}  // namespace geom
