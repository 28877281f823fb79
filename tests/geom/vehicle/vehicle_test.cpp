#include "geom/vehicle/vehicle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/random_city.h"

namespace geom {
namespace {

constexpr double kUpright = std::numbers::pi / 2;

TEST(AttitudeHalfSizes, OfAVehicleThatNeverTiltsHoldEveryYaw) {
  const Vec3 half = attitude_half_sizes({3, 4, 1}, 0);
  EXPECT_NEAR(half.x(), 5, 1e-13);
  EXPECT_NEAR(half.y(), 5, 1e-13);
  EXPECT_NEAR(half.z(), 1, 1e-13);
}

TEST(AttitudeHalfSizes, AtAnyTiltAreTheDiagonal) {
  const Vec3 half = attitude_half_sizes({3, 4, 12}, kUpright);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(half[k], 13, 1e-12);
}

TEST(AttitudeHalfSizes, OfAFlatBodyGrowUpwardAlone) {
  const Vec3 half = attitude_half_sizes({3, 4, 0}, std::numbers::pi / 6);
  EXPECT_NEAR(half.x(), 5, 1e-13);
  EXPECT_NEAR(half.z(), 2.5, 1e-13);
}

// Against ten thousand tilts.
TEST(AttitudeHalfSizes, AreTheMaximaOverAllTiltsRoundedUp) {
  support::Random random(1);
  for (int i = 0; i < 100; ++i) {
    const Vec3 body(random.uniform(0, 2), random.uniform(0, 2), random.uniform(0, 2));
    const double tilt_max = random.uniform(0, kUpright);
    const double r = std::hypot(body.x(), body.y());
    double horizontal = 0;
    double vertical = 0;
    for (int k = 0; k <= 10000; ++k) {
      const double t = tilt_max * k / 10000;
      horizontal = std::max(horizontal, r * std::cos(t) + body.z() * std::sin(t));
      vertical = std::max(vertical, r * std::sin(t) + body.z() * std::cos(t));
    }
    const Vec3 half = attitude_half_sizes(body, tilt_max);
    ASSERT_EQ(half.x(), half.y());
    ASSERT_GE(half.x(), horizontal) << "seed 1, case " << i;
    ASSERT_GE(half.z(), vertical) << "seed 1, case " << i;
    ASSERT_NEAR(half.x(), horizontal, 1e-7) << "seed 1, case " << i;
    ASSERT_NEAR(half.z(), vertical, 1e-7) << "seed 1, case " << i;
  }
}

}  // namespace
}  // namespace geom
