#include "traj/mission/formats/flier.h"

#include <gtest/gtest.h>

namespace traj {
namespace {

TEST(Flier, IsEachAutopilotWhereNoneIsSaid) {
  const MissionRules rules = Flier().rules({});
  EXPECT_EQ(names_of(rules.autopilots), names_of(*autopilots_of("any")));
  EXPECT_FALSE(rules.acceptance || rules.speed || rules.return_height);
}

TEST(Flier, SaysWhatTheRulesLeaveOpen) {
  Flier flier;
  flier.autopilots = {px4("1.17")};
  flier.exactly = px4("1.17");
  flier.exactly->acceleration = 2;
  const MissionRules open = flier.rules({});
  EXPECT_EQ(open.acceptance, 10);
  EXPECT_EQ(open.speed, 5);
  EXPECT_EQ(open.return_height, 30);
  EXPECT_EQ(open.braking, 2) << "less than the rules' 3";
  const MissionRules said = flier.rules({.acceptance = 1, .speed = 4, .return_height = 20});
  EXPECT_EQ(said.acceptance, 1);
  EXPECT_EQ(said.speed, 4);
  EXPECT_EQ(said.return_height, 20);
}

TEST(Flier, AllowsForNavigationAndWhereItTracksForThat) {
  Flier flier;
  EXPECT_EQ(flier.allowance(true), Vec3(0, 0, 0));
  flier.navigation = Uncertainty{0.5, 1};
  flier.tracking = Uncertainty{2, 3};
  EXPECT_EQ(flier.allowance(false), Vec3(0.5, 0.5, 1));
  EXPECT_EQ(flier.allowance(true), Vec3(2.5, 2.5, 4));
}

}  // namespace
}  // namespace traj
