#include "traj/mission/idle_rules.h"

#include <gtest/gtest.h>

namespace traj {
namespace {

std::vector<FileFlight> one(FlownMission mission) {
  return {{.flown = {FlownLegs{}}}, {.flown = {std::move(mission)}}};
}

std::string said(const MissionRules& rules, FlownMission mission = {}) {
  return idle_rule(rules, one(std::move(mission))).value_or("used");
}

TEST(IdleRule, NamesAReturnHeightWithoutAReturn) {
  const MissionRules rules{.return_height = 60};
  EXPECT_EQ(said(rules), "--return-height is for a return home at the mission's end");
  FlownMission returns;
  returns.ends_at_home = true;
  EXPECT_EQ(said(rules, returns), "used");
  EXPECT_EQ(said({}, returns), "used");
}

TEST(IdleRule, NamesAGroundFromWhichNothingCounts) {
  const MissionRules rules{.ground = 3};
  EXPECT_EQ(said(rules), "--terrain-height is for heights above terrain");
  FlownMission flat;
  flat.counts_from_flat_ground = true;
  EXPECT_EQ(said(rules, flat), "used");
}

TEST(IdleRule, NamesATerrainThatNothingFollows) {
  const MissionRules error{.terrain = TerrainRules{.error = 3}};
  const MissionRules band{.terrain = TerrainRules{.surface = SurfaceBand{20, 30}}};
  FlownMission above;
  above.terrain = TerrainClaim{};
  FlownMission follows;
  follows.terrain = TerrainClaim{.surface = SurfaceBand{20, 30}};
  EXPECT_EQ(said(error, above), "used");
  EXPECT_EQ(said(error, follows), "--terrain-error is for heights above terrain");
  EXPECT_EQ(said(band, follows), "used");
  EXPECT_EQ(said(band, above), "--surface-band is for waylines of DJI that follow the surface");
}

}  // namespace
}  // namespace traj
