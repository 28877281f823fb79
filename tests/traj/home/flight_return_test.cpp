#include "traj/home/flight_return.h"

#include <gtest/gtest.h>

namespace traj {
namespace {

TEST(FlightReturn, MayBeKeptLowByAFenceThatAnItemSwitchesOn) {
  FlownMission mission;
  mission.home = Vec3(0, 0, 0);
  Drift drift{.autopilot = ardupilot().name, .sweeps = {}};
  drift.legs = {{.a = {0, 0, 50}, .b = {90, 0, 50}, .from = 0, .until = 10}};
  mission.drift = {drift};
  Flier flier;
  flier.autopilots = {ardupilot()};
  EXPECT_FALSE(flight_return(mission, flier, 120).task.models.front().ceiling);
  mission.switches_fence = true;
  const ReturnModel model = flight_return(mission, flier, 120).task.models.front();
  EXPECT_EQ(model.ceiling, 98);
  EXPECT_FALSE(model.keeps_below_ceiling) << "it may return before that item";
  EXPECT_TRUE(model.fence_excludes);
}

}  // namespace
}  // namespace traj
