#include "geom/map/frame.h"

#include <gtest/gtest.h>

#include <cmath>

namespace geom {
namespace {

TEST(Axes, NamesGoBothWays) {
  EXPECT_EQ(name(Axes::enu), "enu");
  EXPECT_EQ(name(Axes::neu), "neu");
  EXPECT_EQ(value_of(kAxesWords, "enu"), Axes::enu);
  EXPECT_EQ(value_of(kAxesWords, "neu"), Axes::neu);
  EXPECT_EQ(value_of(kAxesWords, "ned"), std::nullopt);
  EXPECT_EQ(value_of(kAxesWords, ""), std::nullopt);
}

TEST(ToEnu, SwapsEastAndNorthWhereNorthComesFirst) {
  EXPECT_EQ(to_enu(Axes::enu, Vec3(1, 2, 3)), Vec3(1, 2, 3));
  EXPECT_EQ(to_enu(Axes::neu, Vec3(1, 2, 3)), Vec3(2, 1, 3));
  EXPECT_EQ(to_enu(Axes::neu, Aabb{{1, 2, 3}, {4, 6, 8}}), (Aabb{{2, 1, 3}, {6, 4, 8}}));
  EXPECT_EQ(to_enu(Axes::neu, to_enu(Axes::neu, Vec3(1, 2, 3))), Vec3(1, 2, 3));
}

TEST(YawToEnu, TurnsAHeadingAsItsDirectionAndIsItsOwnInverse) {
  for (const Axes axes : {Axes::enu, Axes::neu}) {
    for (double yaw = -7; yaw < 7; yaw += 0.3) {
      const double enu = yaw_to_enu(axes, yaw);
      const Vec3 ahead = to_enu(axes, Vec3(std::cos(yaw), std::sin(yaw), 0));
      EXPECT_NEAR(std::cos(enu), ahead.x(), 1e-12) << yaw;
      EXPECT_NEAR(std::sin(enu), ahead.y(), 1e-12) << yaw;
      EXPECT_NEAR(yaw_to_enu(axes, enu), yaw, 1e-15 * 8) << yaw;
    }
  }
}

}  // namespace
}  // namespace geom
