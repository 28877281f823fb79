#include "geom/shape/aabb.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "geom/base/rounding.h"
#include "support/cases.h"
#include "support/exact_oracle.h"
#include "support/random_city.h"

namespace geom {
namespace {

const Aabb kUnit{{0, 0, 0}, {1, 1, 1}};

TEST(AabbDistance, IsZeroInsideAndOnTheFace) {
  EXPECT_EQ(distance({0.5, 0.5, 0.5}, kUnit), 0);
  EXPECT_EQ(distance({1, 0.5, 0.5}, kUnit), 0);
}

TEST(AabbDistance, IsEuclideanAtFacesEdgesAndCorners) {
  EXPECT_EQ(distance({3, 0.5, 0.5}, kUnit), 2);
  EXPECT_EQ(distance({4, 5, 0.5}, kUnit), 5);
  EXPECT_EQ(distance({3, 3, 2}, kUnit), 3);
}

TEST(AabbSegment, TouchingIsAHit) {
  EXPECT_TRUE(segment_hits({-1, 1, 0.5}, {2, 1, 0.5}, kUnit));         // along a face
  EXPECT_TRUE(segment_hits({-1, 2, 0.5}, {2, -1, 0.5}, kUnit));        // through
  EXPECT_TRUE(segment_hits({0, 2, 0.5}, {2, 0, 0.5}, kUnit));          // the edge (1, 1)
  EXPECT_TRUE(segment_hits({1, 1, 1}, {1, 1, 1}, kUnit));              // a corner as a point
  EXPECT_TRUE(segment_hits({0.2, 0.2, 0.2}, {0.3, 0.3, 0.3}, kUnit));  // wholly inside
}

TEST(AabbSegment, OneUlpBesideIsAMiss) {
  const double beyond = std::nextafter(1.0, 2.0);
  EXPECT_FALSE(segment_hits({-1, beyond, 0.5}, {2, beyond, 0.5}, kUnit));
  EXPECT_FALSE(segment_hits({beyond, 0, 0}, {beyond, 0, 0}, kUnit));
  EXPECT_FALSE(
      segment_hits({0, std::nextafter(2.0, 3.0), 0.5}, {2, std::nextafter(0.0, 1.0), 0.5}, kUnit));
}

TEST(AabbClip, GivesThePartInTheClosedBox) {
  const auto through = clip({-1, 0.5, 0.5}, {3, 0.5, 0.5}, kUnit);
  ASSERT_TRUE(through);
  EXPECT_EQ(through->from, 0.25);
  EXPECT_EQ(through->to, 0.5);
  const auto inside = clip({0.2, 0.2, 0.2}, {0.3, 0.3, 0.3}, kUnit);
  ASSERT_TRUE(inside);
  EXPECT_EQ(inside->from, 0);
  EXPECT_EQ(inside->to, 1);
  const auto touching = clip({1, 1, 1}, {2, 2, 2}, kUnit);
  ASSERT_TRUE(touching);
  EXPECT_EQ(touching->to, 0);
  EXPECT_FALSE(clip({-1, 2, 0.5}, {3, 2, 0.5}, kUnit));
  EXPECT_FALSE(clip({-1, 0.5, 0.5}, {2, 3.6, 0.5}, kUnit));  // both extents overlap
}

// Its ends are in the box but for rounding, and what is beyond them is not.
TEST(AabbClip, AgreesWithTheExactTest) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> at(-2, 3);
  const auto point = [&] { return Vec3(at(random), at(random), at(random)); };
  int cut = 0;
  for (int i = 0; i < 5000; ++i) {
    const Vec3 a = point();
    const Vec3 b = point();
    const auto part = clip(a, b, kUnit);
    ASSERT_EQ(part.has_value(), oracle::segment_hits(a, b, kUnit)) << i;
    if (!part) continue;
    ++cut;
    ASSERT_LT(distance(a + part->from * (b - a), kUnit), 1e-14) << i;
    ASSERT_LT(distance(a + part->to * (b - a), kUnit), 1e-14) << i;
    const Vec3 before = a + (part->from - 1e-9) * (b - a);
    const Vec3 after = a + (part->to + 1e-9) * (b - a);
    ASSERT_TRUE(part->from == 0 || !contains(kUnit, before)) << i;
    ASSERT_TRUE(part->to == 1 || !contains(kUnit, after)) << i;
  }
  EXPECT_GT(cut, 500);
}

TEST(AabbBounds, HoldAllBoxesAndNothingMore) {
  EXPECT_FALSE(bounds(std::span<const Aabb>()));
  const std::vector<Aabb> boxes = {{{0, 5, 2}, {1, 6, 3}}, {{-1, 5.5, 2}, {0, 9, 2}}};
  EXPECT_EQ(bounds(boxes), (Aabb{{-1, 5, 2}, {1, 9, 3}}));
}

// A segment with ends on a coarse grid, on nearby doubles, or anywhere.
Vec3 random_point(support::Random& random, double offset) {
  Vec3 p;
  for (int i = 0; i < 3; ++i) {
    p[i] = offset + (random.below(3) ? random.stepped(-3, 3, 0.5) : random.uniform(-3, 3));
    if (random.below(4) == 0) p[i] = std::nextafter(p[i], random.below(2) ? -1e9 : 1e9);
  }
  return p;
}

class AabbSegmentProperty : public testing::TestWithParam<double> {};

TEST_P(AabbSegmentProperty, AgreesWithRationalArithmetic) {
  support::Random random(7);
  for (int i = 0; i < 40000; ++i) {
    Vec3 low = random_point(random, GetParam());
    Vec3 high = random_point(random, GetParam());
    const Aabb box{low.cwiseMin(high), low.cwiseMax(high)};
    const Vec3 a = random_point(random, GetParam());
    const Vec3 b = random.below(10) ? random_point(random, GetParam()) : a;
    ASSERT_EQ(segment_hits(a, b, box), oracle::segment_hits(a, b, box))
        << "case " << i << ": " << a.transpose() << " to " << b.transpose();
  }
}

INSTANTIATE_TEST_SUITE_P(Offsets, AabbSegmentProperty, testing::Values(0.0, 1e3, 1e5, 5e5));

// Side by side with the sum that is rounded outward, and then reaches further out by the slack.
TEST(AabbGrow, IsBitForBitWhatTheRoundedSumsGive) {
  support::Random random(12);
  const auto slack = [](double x) { return std::max(5e-10, 2 * ulp(x)); };
  const auto number = [&] {
    switch (random.below(5)) {
      case 0:
        return random.stepped(-100, 100, 0.25);
      case 1:
        return std::ldexp(random.uniform(-1, 1), random.below(60) - 32);
      case 2:
        return random.below(2) ? 0.0 : -0.0;
      case 3:
        return std::ldexp(random.below(2) ? 1.0 : -1.0, 21) + random.stepped(-2, 2, 1e-9);
      default:
        return random.uniform(-5e3, 5e3);
    }
  };
  for (int i = 0; i < support::cases(200000); ++i) {
    const Vec3 one(number(), number(), number());
    const Vec3 other(number(), number(), number());
    const Aabb box{one.cwiseMin(other), one.cwiseMax(other)};
    const Vec3 half(random.below(4) ? random.uniform(0, 3) : 0, random.stepped(0, 2, 0.125),
                    std::abs(number()));
    const Aabb grown = grow(box, half);
    for (int k = 0; k < 3; ++k) {
      const double low = add_down(box.min[k], -half[k]);
      const double high = add_up(box.max[k], half[k]);
      ASSERT_EQ(grown.min[k], add_down(low, -slack(low))) << "case " << i;
      ASSERT_EQ(grown.max[k], add_up(high, slack(high))) << "case " << i;
    }
  }
}

TEST(AabbGrow, HoldsTheRealSumAndReachesBeyondByAtMostANanometre) {
  using oracle::Q;
  support::Random random(3);
  for (int i = 0; i < 10000; ++i) {
    const Vec3 low(random.uniform(-1e4, 1e4), random.uniform(-1, 1), random.stepped(-9, 9, 0.1));
    const Aabb box{low, low + Vec3(1, 2, 3)};
    const Vec3 half(random.uniform(0, 2), random.uniform(0, 1e-3), 0.1);
    const Aabb grown = grow(box, half);
    for (int k = 0; k < 3; ++k) {
      const Q below = Q(box.min[k]) - Q(half[k]) - Q(grown.min[k]);
      const Q above = Q(grown.max[k]) - (Q(box.max[k]) + Q(half[k]));
      ASSERT_TRUE(below > 0 && below < Q(1e-9)) << i;
      ASSERT_TRUE(above > 0 && above < Q(1e-9)) << i;
    }
  }
}

TEST(AabbShrink, KeepsTheWholeVehicleInsideAndSaysWhenItDoesNotFit) {
  const auto inner = shrink({{0, 0, 0}, {10, 10, 10}}, {1, 2, 5});
  ASSERT_TRUE(inner);
  EXPECT_EQ(inner->min, Vec3(1, 2, 5));
  EXPECT_EQ(inner->max, Vec3(9, 8, 5));
  EXPECT_FALSE(shrink({{0, 0, 0}, {10, 10, 10}}, {1, 1, 5.1}));
  EXPECT_FALSE(shrink({{0, 0, 0}, {10, 10, 10}}, {1, 1, std::nan("")}));
}

TEST(AabbBounds, AreNothingWithoutPoints) {
  EXPECT_FALSE(bounds(std::span<const Vec3>()));
  const Vec3 points[] = {{1, 2, 3}, {-1, 5, 3}};
  EXPECT_EQ(bounds(points), (Aabb{{-1, 2, 3}, {1, 5, 3}}));
}

}  // namespace
}  // namespace geom
