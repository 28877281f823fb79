#include "traj/mission/flown/flown.h"

#include <gtest/gtest.h>

namespace traj {
namespace {

using geom::Axes;

FlownMission mission() {
  FlownMission out;
  out.path = {{1, 2, 3}, {4, 5, 6}};
  out.path_stray = {0.1, 0.2, 0.3};
  out.sweeps = {{{{7, 8, 9}}, {}}};
  out.drift = {{"px4", {{{{1, 0, 0}}, {}}}, {3, 2, 1}}};
  out.fences = {{true, {{5, 6}}, 0}};
  out.rally = {{1, 2, 0}};
  out.touches = {{3, 4, 0}};
  out.home = Vec3(8, 9, 1);
  return out;
}

TEST(Flown, OfAMissionHasLegsAndRegions) {
  const Flown flown{mission()};
  ASSERT_NE(legs_of(flown), nullptr);
  EXPECT_EQ(legs_of(flown), mission_of(flown));
  EXPECT_TRUE(has_drift(flown));
  EXPECT_EQ(begin_of(flown), Vec3(1, 2, 3));
  EXPECT_TRUE(trajectory_of(flown).segments.empty());
}

TEST(Flown, OfLegsHasNoRegions) {
  const Flown flown{FlownLegs{{{1, 2, 3}}}};
  ASSERT_NE(legs_of(flown), nullptr);
  EXPECT_EQ(mission_of(flown), nullptr);
  EXPECT_FALSE(has_drift(flown));
}

TEST(Flown, OfSetpointsIsTheStraightWaysBetween) {
  const Flown flown{FlownSetpoints{{{1, {{0, 0, 5}}, 0, 0}, {3, {{8, 0, 5}}, 0, 0}}}};
  EXPECT_EQ(legs_of(flown), nullptr);
  EXPECT_EQ(begin_of(flown), Vec3(0, 0, 5));
  const Trajectory way = trajectory_of(flown);
  ASSERT_EQ(way.segments.size(), 1u);
  EXPECT_EQ(way.segments[0].duration, 2);
  EXPECT_EQ(way.segments[0].point.back(), Vec3(8, 0, 5));
}

// Whatever has a place or a direction turns with the axes, and twice gives the same again.
TEST(Flown, TurnsWithTheAxesAsAWhole) {
  const Flown flown = to_enu(Axes::neu, Flown{mission(), Vec3(1, 2, 3)});
  const FlownMission& turned = *mission_of(flown);
  EXPECT_EQ(flown.navigation, Vec3(2, 1, 3));
  EXPECT_EQ(turned.path[1], Vec3(5, 4, 6));
  EXPECT_EQ(turned.path_stray, Vec3(0.2, 0.1, 0.3));
  EXPECT_EQ(turned.sweeps[0].hull[0], Vec3(8, 7, 9));
  EXPECT_EQ(turned.drift[0].sweeps[0].hull[0], Vec3(0, 1, 0));
  EXPECT_EQ(turned.drift[0].around, Vec3(2, 3, 1));
  EXPECT_EQ(turned.fences[0].ring[0], geom::Vec2(6, 5));
  EXPECT_EQ(turned.rally[0], Vec3(2, 1, 0));
  EXPECT_EQ(turned.touches[0], Vec3(4, 3, 0));
  EXPECT_EQ(turned.home, Vec3(9, 8, 1));
  EXPECT_EQ(mission_of(to_enu(Axes::neu, flown))->drift[0].around, Vec3(3, 2, 1));
}

TEST(Flown, TurnsTheYawOfSetpoints) {
  const State state{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
  const Flown flown{FlownSetpoints{{{0, state, 0, 0.5}, {1, state, 0, 0.5}}}};
  const Flown turned = to_enu(Axes::neu, flown);
  const Setpoint& s = std::get<FlownSetpoints>(turned.way).setpoints[0];
  EXPECT_EQ(s.state.velocity, Vec3(5, 4, 6));
  EXPECT_EQ(s.state.acceleration, Vec3(8, 7, 9));
  EXPECT_EQ(s.yaw, geom::yaw_to_enu(Axes::neu, 0));
  EXPECT_EQ(s.yaw_rate, -0.5);
}

TEST(Flown, TurnsACurveAndWhatItMayBeOff) {
  Trajectory curve;
  curve.segments.push_back({1, {}, {}});
  curve.segments[0].point.fill({1, 2, 3});
  const Flown turned = to_enu(Axes::neu, Flown{FlownCurve{curve, {{Vec3(3, 2, 1)}}}});
  const FlownCurve& flown = std::get<FlownCurve>(turned.way);
  EXPECT_EQ(flown.trajectory.segments[0].point[4], Vec3(2, 1, 3));
  EXPECT_EQ(flown.stray[0].position, Vec3(2, 3, 1));
}

TEST(Flown, BandsAreOfTheLegsBehindTheAscent) {
  FlownLegs legs;
  legs.path = {{0, 0, 5}, {9, 0, 5}, {9, 9, 5}};
  EXPECT_EQ(band_of(legs, 0), 0);
  legs.leg_band = {2, 3};
  EXPECT_EQ(band_of(legs, 0), 2);
  EXPECT_EQ(band_of(legs, 1), 3);
  EXPECT_EQ(band_of(legs, 2), 0) << "a landing";
  legs.ends.takeoff_from = 0;
  EXPECT_EQ(band_of(legs, 0), 0) << "the ascent";
  EXPECT_EQ(band_of(legs, 1), 2);
  EXPECT_EQ(band_of(legs, 2), 3);
  EXPECT_EQ(band_of(legs, 3), 0);
}

}  // namespace
}  // namespace traj
