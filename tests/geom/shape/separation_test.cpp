#include "geom/shape/separation.h"

#include <gtest/gtest.h>

#include <array>

#include "support/random_city.h"
#include "support/segment_distance.h"

namespace geom {
namespace {

std::array<Vec3, 8> corners(const Aabb& b) {
  std::array<Vec3, 8> out;
  for (std::size_t i = 0; i < 8; ++i) {
    out[i] = {i & 1 ? b.max.x() : b.min.x(), i & 2 ? b.max.y() : b.min.y(),
              i & 4 ? b.max.z() : b.min.z()};
  }
  return out;
}

// Anywhere in a cube around the origin.
Vec3 point(support::Random& random, double half) {
  const double x = random.uniform(-half, half);
  const double y = random.uniform(-half, half);
  return {x, y, random.uniform(-half, half)};
}

Aabb random_box(support::Random& random) {
  const Vec3 p = point(random, 20);
  const Vec3 q = point(random, 20);
  return {p.cwiseMin(q), p.cwiseMax(q)};
}

TEST(Separation, PutsBoxAndSegmentStrictlyOnEitherSide) {
  support::Random random(1);
  int tried = 0;
  while (tried < 2000) {
    const Aabb box = random_box(random);
    const Vec3 a = point(random, 30);
    const Vec3 b = point(random, 30);
    if (segment_hits(a, b, box)) continue;
    ++tried;
    const Separation s = separation(a, b, box);
    ASSERT_GT(s.gap, 0) << "case " << tried;
    EXPECT_LT(s.plane.normal.dot(a), s.plane.offset) << "case " << tried;
    EXPECT_LT(s.plane.normal.dot(b), s.plane.offset) << "case " << tried;
    for (const Vec3& c : corners(box)) {
      EXPECT_GT(s.plane.normal.dot(c), s.plane.offset) << "case " << tried;
    }
    EXPECT_TRUE(behind(box, s.plane));
  }
}

TEST(Separation, HasTheExactDistanceAsItsGap) {
  support::Random random(2);
  for (int i = 0; i < 500; ++i) {
    const Aabb box = random_box(random);
    const Vec3 a = point(random, 30);
    const Vec3 b = point(random, 30);
    const double want = oracle::segment_distance(a, b, box);
    if (want < 2e-3) continue;
    EXPECT_NEAR(separation(a, b, box).gap, want, 1e-7) << "case " << i;
  }
}

TEST(Separation, FindsTheAxisAcrossATinyGap) {
  const Aabb box{Vec3(0, 0, 0), Vec3(1, 1, 1)};
  for (const double gap : {1e-3, 1e-6, 1e-9, 1e-12}) {
    const Separation face = separation(Vec3(-5, -5, 1 + gap), Vec3(5, 5, 1 + gap), box);
    EXPECT_NEAR(face.gap, gap, 1e-15);
    EXPECT_TRUE(behind(box, face.plane));
    // Past the upright edge at (1, 0), across both axes.
    const Separation edge = separation(Vec3(0, -1 - gap, 0.2), Vec3(2, 1 - gap, 0.8), box);
    EXPECT_GT(edge.gap, 0) << gap;
    EXPECT_TRUE(behind(box, edge.plane)) << gap;
  }
}

TEST(Separation, OfAPointAndOfATouchingSegment) {
  const Aabb box{Vec3(0, 0, 0), Vec3(1, 1, 1)};
  EXPECT_NEAR(separation(Vec3(3, 0.5, 0.5), Vec3(3, 0.5, 0.5), box).gap, 2, 1e-15);
  EXPECT_LE(separation(Vec3(-1, 1, 0.5), Vec3(2, 1, 0.5), box).gap, 0);
}

TEST(SegmentDistance, IsThatOfTheNearestPointsAndZeroWhereTheyMeet) {
  const Aabb box{Vec3(0, 0, 0), Vec3(1, 1, 1)};
  EXPECT_EQ(distance(Vec3(-1, 0.5, 0.5), Vec3(2, 0.5, 0.5), box), 0);
  EXPECT_EQ(distance(Vec3(-1, 1, 0.5), Vec3(2, 1, 0.5), box), 0) << "along a face";
  EXPECT_NEAR(distance(Vec3(-1, 4, 5), Vec3(2, 4, 5), box), 5, 1e-15);
  EXPECT_NEAR(distance(Vec3(3, 0, 0), Vec3(3, 0, 0), box), 2, 1e-15);
  support::Random random(4);
  for (int i = 0; i < 500; ++i) {
    const Aabb some = random_box(random);
    const Vec3 a = point(random, 30);
    const Vec3 b = point(random, 30);
    ASSERT_NEAR(distance(a, b, some), oracle::segment_distance(a, b, some), 1e-7)
        << "seed 4, case " << i;
  }
}

TEST(Behind, IsFalseWhereAPointOfTheBoxIsOnThePlane) {
  const Aabb box{Vec3(0, 0, 0), Vec3(1, 1, 1)};
  EXPECT_TRUE(behind(box, {Vec3(1, 0, 0), -1e-9}));
  EXPECT_FALSE(behind(box, {Vec3(1, 0, 0), 0}));
  EXPECT_FALSE(behind(box, {Vec3(-1, 0, 0), -1}));
}

}  // namespace
}  // namespace geom
