#include "sampling/spheroid.h"

#include <gtest/gtest.h>

#include <numbers>

#include "support/random_city.h"

namespace plan {
namespace {

using geom::Vec3;

TEST(Spheroid, HoldsTheImageOfTheUnitBallAndNoMore) {
  support::Random random(3);
  for (int i = 0; i < 200; ++i) {
    Vec3 ends[2];
    for (Vec3& p : ends) {
      for (int k = 0; k < 3; ++k) p[k] = random.stepped(-2, 2, 1) * (i % 3 ? 1 : 100);
    }
    const double distance = (ends[1] - ends[0]).norm();
    const double length = distance + random.uniform(0, i % 2 ? 5 : 1e-9);
    const Spheroid spheroid(ends[0], ends[1], length);
    Vec3 unit(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    unit.normalize();
    const auto sum = [&](const Vec3& p) { return (p - ends[0]).norm() + (ends[1] - p).norm(); };
    EXPECT_NEAR(sum(spheroid.image(unit)), length, 1e-12 * (1 + length)) << i;
    if (length > distance + 1e-3) {
      EXPECT_TRUE(spheroid.contains(spheroid.image(0.99 * unit))) << i;
      EXPECT_FALSE(spheroid.contains(spheroid.image(1.01 * unit))) << i;
    }
  }
}

TEST(Spheroid, HasTheVolumeOfTheBallWhereTheEndsAreOne) {
  EXPECT_NEAR(Spheroid({1, 2, 3}, {1, 2, 3}, 4).volume(), 4 * std::numbers::pi / 3 * 8, 1e-12);
  EXPECT_NEAR(Spheroid({0, 0, 0}, {3, 0, 0}, 5).volume(), 4 * std::numbers::pi / 3 * 2.5 * 2 * 2,
              1e-12);
  EXPECT_EQ(Spheroid({0, 0, 0}, {3, 0, 0}, 2).volume(), 0);  // taken as 3
}

}  // namespace
}  // namespace plan
