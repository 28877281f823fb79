#include "traj/mission/mavlink/mission.h"

#include <gtest/gtest.h>

#include <sstream>

#include "traj/mission/formats/qgc_plan.h"
#include "traj/mission/formats/wpl.h"
#include "traj/mission/mavlink/examples.h"
#include "traj/mission/mavlink/mission_flight.h"

namespace traj {
namespace {

using testing::kFrame;
using testing::kPoints;
using testing::mission_options;

void expect_flown(const FlownMavlink& flown) {
  ASSERT_EQ(flown.path.size(), kPoints.size() + 1) << "with a rest where it took off to";
  for (std::size_t i = 0; i < flown.path.size(); ++i) {
    const Vec3& p = kPoints[i == 0 ? 0 : i - 1];
    EXPECT_LT((flown.path[i] - p).head<2>().norm(), 0.008) << "1e-7 degrees";
    EXPECT_NEAR(flown.path[i].z(), p.z(), 0.0006);
  }
  EXPECT_EQ(flown.hold, (std::vector<double>{0, 3, 3, 3}));
  EXPECT_EQ(flown.corners, 0u);
  EXPECT_NEAR(*flown.ends.takeoff_from, 2, 0.0006);
  EXPECT_NEAR(*flown.ends.landing_on, 6.5, 0.0006);
  EXPECT_EQ(flown.speed, 4.5);
  EXPECT_FALSE(flown.returns);
}

TEST(Mission, ComesBackFromBothFilesAsItWasMade) {
  const Mission mission = make_mission(kPoints, kFrame, mission_options());
  expect_flown(flown_mission(mission, kFrame, {}, "mission"));
  std::stringstream wpl;
  write_wpl(wpl, mission);
  expect_flown(flown_mission(read_wpl(wpl, "m.wpl"), kFrame, {}, "m.wpl"));
  std::stringstream plan;
  write_qgc_plan(plan, mission, "test");
  expect_flown(flown_mission(read_qgc_plan(plan, "m.plan"), kFrame, {}, "m.plan"));
}

TEST(Mission, AHomeThatIsGivenCountsBeforeTheFiles) {
  const Mission mission = make_mission(kPoints, kFrame, mission_options());
  const FlownMavlink flown = flown_mission(mission, kFrame, {.home = 102.0}, "mission");
  EXPECT_NEAR(flown.path[2].z(), kPoints[1].z() + 100, 0.0006);
}

TEST(Mission, PassesPointsAndSlowsDownAsAsked) {
  MissionOptions options = mission_options();
  options.passed = {true, true, true};
  options.approach = {0, 0, 1.5};
  options.slowing = 40;
  const Mission mission = make_mission(kPoints, kFrame, options);
  std::vector<int> commands;
  std::vector<std::size_t> points;
  for (const MissionItem& item : mission.items) {
    commands.push_back(item.command);
    points.push_back(item.point);
  }
  EXPECT_EQ(commands, (std::vector<int>{kTakeoff, kSpeed, kWaypoint, kWaypoint, kWaypoint, kSpeed,
                                        kWaypoint, kLand}));
  EXPECT_EQ(points, (std::vector<std::size_t>{0, 0, 0, 1, 2, 2, 2, 2}));
  EXPECT_EQ(mission.items[2].param[0], 3) << "the first rests, and so does the last";
  EXPECT_EQ(mission.items[3].param[0], 0);
  EXPECT_EQ(mission.items[5].param[1], 1.5);
  EXPECT_EQ(mission.items[6].param[0], 3);
  const FlownMavlink flown = flown_mission(mission, kFrame, {}, "mission");
  EXPECT_NEAR((flown.path[3] - flown.path[4]).norm(), 40, 0.02);
}

}  // namespace
}  // namespace traj
