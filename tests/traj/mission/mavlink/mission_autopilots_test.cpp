#include "mission/mavlink/mission_autopilots.h"

#include <gtest/gtest.h>

#include "traj/mission/firmware/autopilot.h"
#include "traj/mission/mavlink/examples.h"

namespace traj {
namespace {

const MissionFrame kAtHome{{47, 8, 410.5}, 0};

std::string said_of(const MissionRules& rules, double precision) {
  Mission mission = testing::every_item();
  mission.items.back().param[1] = precision;
  return support::refusal_of([&] { flown_mission(mission, kAtHome, rules, "m"); });
}

MissionRules rules_of(const char* word) { return {.autopilots = *autopilots_of(word)}; }

TEST(MissionAutopilots, RefuseALandingBesideABeacon) {
  for (const char* word : {"px4", "px4:1.13", "any"}) {
    EXPECT_EQ(said_of(rules_of(word), 0), "") << word;
    EXPECT_EQ(said_of(rules_of(word), std::nan("")), "") << word;
    for (const double precision : {1.0, 2.0, 0.5, -1.0}) {
      EXPECT_TRUE(support::says(said_of(rules_of(word), precision), "precision of a landing"))
          << word << ' ' << precision;
    }
  }
  EXPECT_EQ(said_of(rules_of("ardupilot"), 2), "") << "its parameter says whether";
  MissionRules beacon = rules_of("ardupilot");
  beacon.autopilots.front().lands_below = false;
  EXPECT_TRUE(support::says(said_of(beacon, 0), "PLND_ENABLED"));
}

TEST(MissionAutopilots, RefuseOnesThatGoRoundObstacles) {
  for (const auto& [word, name] :
       {std::pair("px4", "COM_OBS_AVOID"), std::pair("ardupilot", "OA_TYPE")}) {
    MissionRules rules = rules_of(word);
    rules.autopilots.back().keeps_to_legs = false;
    EXPECT_TRUE(support::says(said_of(rules, 0), name)) << said_of(rules, 0);
  }
}

}  // namespace
}  // namespace traj
