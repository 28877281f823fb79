#include "mission/mavlink/mission_clock.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "traj/mission/mavlink/examples.h"
#include "traj/mission/mavlink/mission_flight.h"

namespace traj {
namespace {

constexpr double kEast = 1e-3;  // degrees of longitude, some 76 m at 47 degrees north

// Takes off at home, and flies these items.
FlownMavlink flown(const std::vector<MissionItem>& items, const char* word = "ardupilot") {
  Mission mission;
  mission.home = geom::GeodeticPlace{47, 8, 410.5};
  mission.items = {{kGlobalRelative, kTakeoff, {0, 0, 0, 0}, 47, 8, 20}};
  mission.items.insert(mission.items.end(), items.begin(), items.end());
  for (std::size_t i = 0; i < mission.items.size(); ++i) mission.items[i].number = i + 1;
  return flown_mission(mission, {{47, 8, 410.5}, 0}, {.autopilots = *autopilots_of(word)}, "m");
}

MissionItem at(int command, std::array<double, 4> param, double east, double height = 20) {
  return {kGlobalRelative, command, param, 47, 8 + east, height};
}

MissionItem speed(double type, double metres) {
  return {kMissionFrame, kSpeed, {type, metres, -1, 0}, 0, 0, 0};
}

TEST(MissionClock, CountsEachLegAtItsOwnSpeed) {
  const double fast =
      flown({speed(1, 10), at(kWaypoint, {}, kEast), at(kWaypoint, {}, 0)}).least_seconds;
  const double slow =
      flown({speed(1, 10), at(kWaypoint, {}, kEast), speed(1, 0.5), at(kWaypoint, {}, 0)})
          .least_seconds;
  EXPECT_NEAR(slow - fast, 76.1 / 0.5 - 76.1 / 10, 0.5);
}

TEST(MissionClock, CountsTheVehiclesOwnSpeedWhereTheFileSaysNoOther) {
  const MissionItem leg = at(kWaypoint, {}, kEast);
  const MissionItem back = at(kWaypoint, {}, 0);
  const double own = flown({leg, back}).least_seconds;
  EXPECT_LT(flown({speed(1, 100), speed(1, -1), leg, back}).least_seconds, own) << "as it is";
  for (const char* pilot : {"px4", "any"}) {
    const double slow = flown({leg, back}, pilot).least_seconds;
    EXPECT_NEAR(flown({speed(1, 100), speed(1, -1), leg, back}, pilot).least_seconds, slow, 1e-9);
  }
}

TEST(MissionClock, CountsRatesOfClimbAndDescent) {
  const double usual = flown({at(kWaypoint, {}, 0, 50), at(kWaypoint, {}, 0, 20)}).least_seconds;
  const double climb =
      flown({speed(2, 0.1), at(kWaypoint, {}, 0, 50), at(kWaypoint, {}, 0, 20)}).least_seconds;
  const double descent =
      flown({speed(3, 0.1), at(kWaypoint, {}, 0, 50), at(kWaypoint, {}, 0, 20)}).least_seconds;
  EXPECT_NEAR(climb - usual, 300, 20);
  EXPECT_NEAR(descent - usual, 300, 25);
}

TEST(MissionClock, CountsHoldsDelaysAndTurns) {
  const auto with = [](const MissionItem& item) {
    return flown({speed(1, 10), at(kWaypoint, {1, 0, 0, 0}, kEast), item,
                  at(kWaypoint, {}, 2 * kEast)})
        .least_seconds;
  };
  const double none = with(speed(1, 10));
  EXPECT_NEAR(with({kMissionFrame, kDelay, {50, 0, 0, 0}, 0, 0, 0}) - none, 50, 1e-6);
  EXPECT_NEAR(with(at(kLoiterTime, {70, 0, 0, 0}, kEast)) - none, 70, 1e-6);
  const double once = with(at(kLoiterTurns, {1, 0, 20, 0}, 2 * kEast));
  const double often = with(at(kLoiterTurns, {200, 0, 20, 0}, 2 * kEast));
  EXPECT_NEAR(often - once, 199 * 18, 1e-3);
  const double wide = with(at(kLoiterTurns, {2, 0, 100, 0}, 2 * kEast));
  EXPECT_GT(wide - once, 2 * std::numbers::pi * 100 / 10);
}

TEST(MissionClock, KnowsWhatMayTakeForEver) {
  EXPECT_EQ(flown({at(kWaypoint, {1, 0, 0, 0}, kEast)}).endless, "");
  EXPECT_NE(flown({at(kWaypoint, {1, 0, 0, 0}, kEast),
                   {kMissionFrame, kDelay, {-1, 23, 59, 59}, 0, 0, 0}})
                .endless,
            "");
  const auto waits = [](double seconds, const char* pilot) {
    return flown({at(kWaypoint, {1, 0, 0, 0}, kEast),
                  {kMissionFrame, kDelay, {seconds, 0, 0, 0}, 0, 0, 0}},
                 pilot)
        .endless;
  };
  EXPECT_NE(waits(0, "ardupilot"), "") << "until midnight";
  EXPECT_NE(waits(0, "any"), "");
  EXPECT_NE(waits(std::nan(""), "any"), "");
  EXPECT_EQ(waits(0, "px4"), "");
  EXPECT_EQ(waits(1, "any"), "");
  EXPECT_NE(flown({at(kLoiterForever, {}, kEast)}).endless, "");
  EXPECT_NE(flown({at(kWaypoint, {1, 0, 0, 0}, kEast),
                   at(kWaypoint, {1, 0, 0, 0}, 0),
                   {kMissionFrame, kJump, {2, -1, 0, 0}, 0, 0, 0}})
                .endless,
            "");
}

}  // namespace
}  // namespace traj
