#include "traj/mission/formats/flier.h"

#include <gtest/gtest.h>

#include "geom/base/usage_error.h"

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

TEST(Flier, ReturnsAtTheHeightOfItsParameters) {
  EXPECT_EQ(Flier().return_height(60), 60);
  EXPECT_FALSE(Flier().return_height({}));
  const auto set = [](const char* parameters) {
    return with_autopilots({}, {.word = "any", .parameters = parameters, .parameters_name = "p"});
  };
  const Flier says = set("RTL_ALT 3000\n");
  EXPECT_EQ(says.return_height({}), 30);
  EXPECT_EQ(says.return_height(30.004), 30);
  EXPECT_EQ(says.rules({.return_height = 30}).return_height, 30);
  EXPECT_THROW(says.return_height(60), geom::UsageError);
  EXPECT_THROW(says.rules({.return_height = 60}), geom::UsageError);
  const Flier silent = set("WPNAV_SPEED 500\n");
  EXPECT_EQ(silent.return_height({}), 15) << "the firmware's";
  EXPECT_EQ(silent.return_height(60), 60) << "nothing says otherwise";
}

TEST(Flier, AllowsForNavigationAndWhereItTracksForThat) {
  Flier flier;
  EXPECT_EQ(flier.allowance(true), Vec3(0, 0, 0));
  flier.navigation = Uncertainty{0.5, 1};
  flier.tracking = Uncertainty{2, 3};
  EXPECT_EQ(flier.allowance(false), Vec3(0.5, 0.5, 1));
  EXPECT_EQ(flier.allowance(true), Vec3(2.5, 2.5, 4));
}

TEST(WithAutopilots, IsAnyOfAWordWithTheDrag) {
  Flier flier;
  flier.navigation = Uncertainty{0.5, 1};
  const Flier set = with_autopilots(flier, {.word = "px4:1.17", .drag = 0.9});
  EXPECT_EQ(names_of(set.autopilots), names_of(*autopilots_of("px4:1.17")));
  EXPECT_EQ(set.navigation->across, 0.5);
  EXPECT_FALSE(set.exactly);
  const Flier usual = with_autopilots(flier, {.word = "px4:1.17"});
  EXPECT_NE(set.autopilots[0].drag, usual.autopilots[0].drag);
}

TEST(WithAutopilots, KnowsExactlyTheOneOfTheParameters) {
  const Flier set = with_autopilots(
      {},
      {.word = "px4:1.17", .parameters = "MPC_XY_CRUISE 4.5\n", .parameters_name = "quad.params"});
  ASSERT_EQ(set.autopilots.size(), 1u);
  ASSERT_TRUE(set.exactly);
  EXPECT_EQ(set.exactly->speed, 4.5);
}

TEST(WithAutopilots, RefusesAWordThatNobodyKnows) {
  EXPECT_THROW(with_autopilots({}, {.word = "px5"}), geom::UsageError);
}

}  // namespace
}  // namespace traj
