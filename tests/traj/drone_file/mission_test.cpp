#include "traj/drone_file/mission.h"

#include <gtest/gtest.h>

#include <sstream>

#include "traj/drone_file/examples.h"
#include "traj/drone_file/mission_flight.h"
#include "traj/drone_file/qgc_plan.h"
#include "traj/drone_file/wpl.h"

namespace traj {
namespace {

using testing::kFrame;
using testing::kPoints;
using testing::mission_options;

void expect_flown(const FlownMission& flown) {
  ASSERT_EQ(flown.path.size(), kPoints.size());
  for (std::size_t i = 0; i < kPoints.size(); ++i) {
    EXPECT_LT((flown.path[i] - kPoints[i]).head<2>().norm(), 0.008) << "1e-7 degrees";
    EXPECT_NEAR(flown.path[i].z(), kPoints[i].z(), 0.0006);
  }
  EXPECT_EQ(flown.hold, (std::vector<double>{0, 1, 1}));
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
  const FlownMission flown = flown_mission(mission, kFrame, {.home = 102.0}, "mission");
  EXPECT_NEAR(flown.path[1].z(), kPoints[1].z() + 100, 0.0006);
}

}  // namespace
}  // namespace traj
