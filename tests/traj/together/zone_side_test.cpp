#include "together/zone_side.h"

#include <gtest/gtest.h>

#include "support/random_city.h"

namespace traj {
namespace {

Points<kPoints> around(const Vec3& middle, double spread, support::Random& random) {
  Points<kPoints> q;
  for (Vec3& p : q) {
    for (int i = 0; i < 3; ++i) p[i] = middle[i] + random.uniform(-spread, spread);
  }
  return q;
}

TEST(ZoneSide, IsBeyondOnlyWhereEveryPointIsOutside) {
  support::Random random(1);
  int beyond_count = 0;
  for (int i = 0; i < 20000; ++i) {
    const Zone zone = random.below(2) ? cylinder(5, 2) : Zone{false, {3, 4, 5}};
    const Vec3 middle(random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9));
    const auto q = around(middle, 1, random);
    if (!beyond(zone, q, 1e-9)) continue;
    ++beyond_count;
    for (const Vec3& p : q) EXPECT_GT(share_of(zone, p), 1);
    // Nor is any mean of them inside.
    Vec3 mean = Vec3::Zero();
    for (const Vec3& p : q) mean += p / kPoints;
    EXPECT_GT(share_of(zone, mean), 1);
  }
  EXPECT_GT(beyond_count, 5000);
}

TEST(ZoneSide, FindsAnUprightPlaneThatNoAxisHas) {
  Points<kPoints> q;
  for (int i = 0; i < kPoints; ++i) q[i] = Vec3(4.01, 4.01, 0) + 0.05 * i * Vec3(1, -1, 0);
  EXPECT_TRUE(beyond(cylinder(5.67, 9), q, 0));
  EXPECT_FALSE(beyond(cylinder(5.68, 9), q, 0));
  EXPECT_FALSE(beyond(Zone{false, {5.67, 5.67, 9}}, q, 0));
}

TEST(ZoneSide, IsNeverBeyondWhatItTouches) {
  Points<kPoints> q;
  q.fill({3, 4, 0});
  EXPECT_FALSE(beyond(cylinder(5, 1), q, 0));
  EXPECT_TRUE(beyond(cylinder(4.999, 1), q, 0));
  EXPECT_FALSE(beyond(cylinder(4.999, 1), q, 2e-3));
  q.fill({0, 0, 1});
  EXPECT_FALSE(beyond(cylinder(5, 1), q, 0));
  q.fill({std::nan(""), 0, 0});
  EXPECT_FALSE(beyond(cylinder(5, 1), q, 0));
}

TEST(ZoneSide, IsWithinOnlyWhatSurelyIs) {
  EXPECT_TRUE(within(cylinder(5, 1), {3, 3.9, 0.9}, 1e-3));
  EXPECT_FALSE(within(cylinder(5, 1), {3, 3.9, 0.9}, 0.2));
  EXPECT_FALSE(within(cylinder(5, 1), {4, 4, 0}, 0));
  EXPECT_TRUE(within(Zone{false, {5, 5, 1}}, {4, 4, 0}, 0.5));
  EXPECT_FALSE(within(Zone{false, {5, 5, 1}}, {std::nan(""), 4, 0}, 0));
}

TEST(ZoneSide, LeastShareIsNoMoreThanThatOfAnyPoint) {
  support::Random random(2);
  for (int i = 0; i < 2000; ++i) {
    const Zone zone = random.below(2) ? cylinder(5, 2) : Zone{false, {3, 4, 5}};
    const Vec3 middle(random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9));
    const auto q = around(middle, 2, random);
    for (const Vec3& p : q) EXPECT_LE(least_share(zone, hull_box(q)), share_of(zone, p));
  }
}

}  // namespace
}  // namespace traj
