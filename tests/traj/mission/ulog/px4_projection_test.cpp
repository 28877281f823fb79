#include "traj/mission/ulog/px4_projection.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace traj {
namespace {

constexpr double kRadian = std::numbers::pi / 180;
constexpr double kRadius = 6371000;

TEST(Px4Projection, IsTheReferenceAtNoDistance) {
  const geom::GeodeticPlace place = px4_place({47, 8, 400}, 0, 0);
  EXPECT_EQ(place.latitude, 47);
  EXPECT_EQ(place.longitude, 8);
  EXPECT_EQ(place.height, 400);
}

TEST(Px4Projection, GoesAlongTheMeridianOfASphere) {
  const geom::GeodeticPlace place = px4_place({47, 8, 400}, 1000, 0);
  EXPECT_NEAR(place.latitude, 47 + 1000 / kRadius / kRadian, 1e-12);
  EXPECT_NEAR(place.longitude, 8, 1e-12);
}

// Great-circle distance and azimuth of the place are those of the local coordinates.
TEST(Px4Projection, KeepsDistanceAndAzimuth) {
  for (const double latitude : {-60.0, 0.0, 37.8, 89.0}) {
    for (const double azimuth : {0.1, 1.7, 3.0, 5.5}) {
      const double far = 12000;
      const geom::GeodeticPlace place =
          px4_place({latitude, 120, 0}, far * std::cos(azimuth), far * std::sin(azimuth));
      const double a = latitude * kRadian;
      const double b = place.latitude * kRadian;
      const double across = (place.longitude - 120) * kRadian;
      const double half = std::pow(std::sin((b - a) / 2), 2) +
                          std::cos(a) * std::cos(b) * std::pow(std::sin(across / 2), 2);
      EXPECT_NEAR(2 * kRadius * std::asin(std::sqrt(half)), far, 1e-6) << latitude;
      const double y = std::sin(across) * std::cos(b);
      const double x = std::cos(a) * std::sin(b) - std::sin(a) * std::cos(b) * std::cos(across);
      EXPECT_NEAR(std::remainder(std::atan2(y, x) - azimuth, 2 * std::numbers::pi), 0, 1e-9);
    }
  }
}

}  // namespace
}  // namespace traj
