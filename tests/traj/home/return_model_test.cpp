#include "traj/home/return_model.h"

#include <gtest/gtest.h>

namespace traj {
namespace {

TEST(ReturnModel, HasTheParametersOfItsAutopilot) {
  Autopilot autopilot = px4("1.15");
  autopilot.return_height = 42;
  autopilot.return_climb = 7;
  autopilot.return_slope = 0.5;
  autopilot.acceleration = 2;
  const ReturnModel model = return_model(autopilot);
  EXPECT_EQ(model.autopilot, "px4:1.15");
  EXPECT_EQ(model.height, 42);
  EXPECT_EQ(model.least_climb, 7);
  EXPECT_EQ(model.slope, 0.5);
  EXPECT_LE(model.deceleration, 2);
  EXPECT_TRUE(model.known);
  EXPECT_TRUE(model.rally_adds);
  EXPECT_TRUE((model.around.array() >= autopilot.tracking.array()).all());
}

TEST(ReturnModel, IsNotKnownWhereAnAutopilotMayLandElsewhere) {
  Autopilot autopilot = px4();
  autopilot.returns_home = false;  // RTL_TYPE
  EXPECT_FALSE(return_model(autopilot).known);
}

TEST(ReturnModel, IsNotKnownWhereAnAutopilotClimbsToHoldBeforeItReturns) {
  Autopilot autopilot = px4("1.11");
  autopilot.climbs_to_hold = true;  // MIS_LTRMIN_ALT
  EXPECT_FALSE(return_model(autopilot).known);
}

TEST(ReturnModel, KeepsBelowItsCeilingUnlessAnotherVersionDoesNot) {
  Autopilot autopilot = ardupilot();
  EXPECT_FALSE(return_model(autopilot).ceiling);
  autopilot.fence.return_ceiling = 48;
  EXPECT_EQ(return_model(autopilot).ceiling, 48);
  EXPECT_TRUE(return_model(autopilot).keeps_below_ceiling);
  autopilot.highest_item = 48;  // LNDMC_ALT_MAX
  EXPECT_FALSE(return_model(autopilot).keeps_below_ceiling);
}

TEST(ReturnModel, ArduPilotLeavesFarRallyPointsOut) {
  EXPECT_EQ(return_model(ardupilot()).rally_limit, 300);
  EXPECT_FALSE(return_model(ardupilot()).rally_adds);
}

TEST(ReturnModel, OfDjiStaysLowNearHome) {
  const ReturnModel model = dji_return_model(35);
  EXPECT_EQ(model.height, 35);
  EXPECT_EQ(model.low_within, 50);
  EXPECT_TRUE(model.known);
}

// No vehicle stops on less than v^2 / 2a, with what it reacts late.
TEST(BrakingWay, GrowsWithTheSpeedAndIsNoLessThanEvenBraking) {
  for (const ReturnModel& model :
       {return_model(px4()), return_model(ardupilot()), dji_return_model(60)}) {
    double before = 0;
    for (double speed = 0; speed <= 30; speed += 0.5) {
      const double way = braking_way(model, speed);
      EXPECT_GE(way, before);
      EXPECT_GE(way, speed * model.reaction + speed * speed / (2 * model.deceleration));
      EXPECT_GE(way, speed * braking_factor(model, speed));
      EXPECT_LE(braking_factor(model, speed), braking_factor(model, speed + 1));
      before = way;
    }
  }
}

}  // namespace
}  // namespace traj
