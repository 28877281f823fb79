#include "traj/curve/to_enu.h"

#include <gtest/gtest.h>

#include <numbers>

#include "traj/mission/mavlink/examples.h"

namespace traj {
namespace {

using testing::example;

TEST(InEnu, SwapsXAndYAndTurnsYawAndIsItsOwnInverse) {
  Trajectory t = example();
  t.segments[0].yaw = {0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7};
  const Trajectory enu = to_enu(geom::Axes::neu, t);
  EXPECT_EQ(enu.segments[0].point[0], Vec3(-120.5, 300.25, 20));
  EXPECT_DOUBLE_EQ((*enu.segments[0].yaw)[7], std::numbers::pi / 2 - 0.7);
  EXPECT_EQ(to_enu(geom::Axes::neu, enu).segments[1].point, t.segments[1].point);
  EXPECT_EQ(to_enu(geom::Axes::enu, t).segments[1].point, t.segments[1].point);
}

TEST(InEnu, SwapsEveryDerivativeOfAStateAndEveryPointOfAPath) {
  const State s{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {10, 11, 12}};
  const State enu = to_enu(geom::Axes::neu, s);
  EXPECT_EQ(enu.position, Vec3(2, 1, 3));
  EXPECT_EQ(enu.velocity, Vec3(5, 4, 6));
  EXPECT_EQ(enu.acceleration, Vec3(8, 7, 9));
  EXPECT_EQ(enu.jerk, Vec3(11, 10, 12));
  EXPECT_EQ(to_enu(geom::Axes::enu, s).jerk, s.jerk);
  EXPECT_EQ(to_enu(geom::Axes::neu, geom::Polyline{{1, 2, 3}, {4, 5, 6}}),
            (geom::Polyline{{2, 1, 3}, {5, 4, 6}}));
}

}  // namespace
}  // namespace traj
