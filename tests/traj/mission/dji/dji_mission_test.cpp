#include "traj/mission/dji/dji_mission.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "traj/mission/dji/dji_flight_examples.h"
#include "traj/mission/mavlink/examples.h"

namespace traj {
namespace {

using testing::kFrame;
using testing::kPoints;

TEST(MakeDjiMission, IsFlownThroughThePoints) {
  DjiOptions options;
  options.home = 2;
  options.speed = 4.5;
  const DjiMission m = make_dji_mission(kPoints, kFrame, options);
  EXPECT_EQ(m.finish, DjiFinish::land);
  const FlownDji flown = flown_dji(m, kFrame, {}, "m");
  ASSERT_EQ(flown.path.size(), kPoints.size());
  for (std::size_t i = 0; i < kPoints.size(); ++i) {
    EXPECT_LT((flown.path[i] - kPoints[i]).norm(), 6e-4) << i;
  }
  EXPECT_NEAR(*flown.ends.takeoff_from, 2, 1e-9);
  EXPECT_EQ(flown.speed, 4.5);
}

TEST(MakeDjiMission, BeginsLowWithARiseToTwoMetres) {
  DjiOptions options;
  options.lands = false;
  const std::vector<Vec3> low = {{0, 0, 1}, {50, 0, 1}};
  const DjiMission m = make_dji_mission(low, kFrame, options);
  EXPECT_EQ(m.security_height, 2);
  EXPECT_EQ(m.finish, DjiFinish::hover);
  EXPECT_EQ(m.transit_speed, 5) << "where none is asked for";
  const FlownDji flown = flown_dji(m, kFrame, {}, "m");
  ASSERT_EQ(flown.path.size(), 3u);
  EXPECT_NEAR(flown.path[0].z(), 2, 1e-9);
  EXPECT_NEAR(flown.path[1].z(), 1, 1e-9);
}

TEST(MakeDjiMission, TurnsWhereItMayAndStopsElsewhere) {
  DjiOptions options;
  options.turns = {10, 10, 10, 0, 10, 10, 10};
  const std::vector<Vec3> points = {{0, 0, 20},  {50, 0, 20},   {50, 8, 20}, {50, 90, 20},
                                    {0, 90, 20}, {0, 90.3, 20}, {0, 99, 20}};
  const auto made = make_dji_mission(points, kFrame, options).waylines[0].waypoints;
  const auto damping = [&](std::size_t i) {
    EXPECT_EQ(made[i].turn, made[i].damping > 0 ? DjiTurn::early : DjiTurn::stop) << i;
    return made[i].damping;
  };
  EXPECT_EQ(damping(0), 0);
  EXPECT_EQ(damping(1), 3.6) << "0.45 of 8 m";
  EXPECT_EQ(damping(2), 3.6);
  EXPECT_EQ(damping(3), 0) << "as asked";
  EXPECT_EQ(damping(4), 0) << "no room";
  EXPECT_EQ(damping(6), 0);
}

TEST(MakeDjiMission, TakesOffWhereTheAircraftStands) {
  DjiOptions options;
  options.takeoff = Vec3(-40, 12, 3);
  options.home = 3;
  const DjiMission m = make_dji_mission(kPoints, kFrame, options);
  EXPECT_EQ(m.without_link, "goBack") << "it returns unless it is told otherwise";
  const FlownDji flown = flown_dji(m, kFrame, {}, "m");
  ASSERT_EQ(flown.path.size(), kPoints.size() + 1);
  EXPECT_LT((flown.path[0] - Vec3(-40, 12, kPoints[0].z())).norm(), 6e-4);
  for (std::size_t i = 0; i < kPoints.size(); ++i) {
    EXPECT_LT((flown.path[i + 1] - kPoints[i]).norm(), 6e-4) << i;
  }
  EXPECT_NEAR(*flown.ends.takeoff_from, 3, 1e-9);
}

TEST(MakeDjiMission, IsNoFasterThanFifteenMetresASecond) {
  DjiOptions options;
  options.speed = 20;
  EXPECT_EQ(make_dji_mission(kPoints, kFrame, options).transit_speed, 15);
  options.speed = 0.2;
  const DjiMission slow = make_dji_mission(kPoints, kFrame, options);
  EXPECT_EQ(slow.waylines[0].waypoints[0].speed, 0.2);
  EXPECT_EQ(slow.transit_speed, 1) << "DJI documents no less";
}

}  // namespace
}  // namespace traj
