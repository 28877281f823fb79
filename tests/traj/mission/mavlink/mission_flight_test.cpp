#include "traj/mission/mavlink/mission_flight.h"

#include <gtest/gtest.h>

#include <limits>

#include "traj/mission/mavlink/mission_maker.h"

namespace traj {
namespace {

using testing::expect_near;
using testing::holds;
using testing::kArduPilot;
using testing::kHomeFrame;
using testing::kPx4;
using testing::swept;
using Maker = testing::MissionMaker;

TEST(FlownMission, SweepsTheCornersOfWaypointsWithoutARest) {
  Maker maker;
  maker.add(kWaypoint, {100, 0, 30}).add(kWaypoint, {100, 80, 30}, {2, 0.2, 0, 0});
  maker.add(kWaypoint, {0, 80, 30});
  const FlownMavlink flown = maker.fly();
  ASSERT_EQ(flown.path.size(), 4u);
  EXPECT_EQ(flown.corners, 1u);
  ASSERT_EQ(flown.sweeps.size(), 1u) << "it rests at the second, and the third is the end";
  EXPECT_EQ(flown.sweeps[0].part, (FlightPart{2, Manoeuvre::corner}));
  EXPECT_EQ(flown.legs[1], (FlightPart{2, Manoeuvre::leg}));
  EXPECT_TRUE(holds(flown.sweeps[0].hull, {95, 5, 30})) << "10 m, the default";
  EXPECT_FALSE(holds(flown.sweeps[0].hull, {94, 5, 30}));
  EXPECT_TRUE(holds(flown.sweeps[0].hull, {106.6, 0, 30})) << "10 m/s and 3 m/s2";
  EXPECT_FALSE(holds(flown.sweeps[0].hull, {106.7, 0, 30}));
}

TEST(FlownMission, TakesTheRadiusFromTheUserThenFromTheItem) {
  Maker maker;
  maker.add(kWaypoint, {100, 0, 30}, {0, 4, 0, 0}).add(kWaypoint, {100, 80, 30});
  EXPECT_TRUE(swept(maker.fly(), Manoeuvre::corner, {96.1, 0, 30}));
  EXPECT_FALSE(swept(maker.fly(), Manoeuvre::corner, {95.9, 0, 30}));
  EXPECT_TRUE(swept(maker.fly({.acceptance = 7}), Manoeuvre::corner, {93.1, 0, 30}));
  EXPECT_TRUE(swept(maker.fly({.acceptance = 1}), Manoeuvre::corner, {96.1, 0, 30})) << "PX4's";
  Maker narrow;
  narrow.add(kWaypoint, {100, 0, 30}, {0, 0.1, 0, 0}).add(kWaypoint, {100, 80, 30});
  EXPECT_TRUE(swept(narrow.fly(), Manoeuvre::corner, {98.1, 0, 30})) << "ArduPilot's 2 m";
  Maker plain;
  plain.add(kWaypoint, {100, 0, 30}).add(kWaypoint, {100, 80, 30});
  EXPECT_TRUE(plain.fly({.acceptance = 0}).sweeps.empty());
  EXPECT_EQ(maker.fly({.acceptance = 0}).corners, 1u);
  EXPECT_FALSE(swept(maker.fly({.speed = 3, .braking = 3}), Manoeuvre::corner, {100.1, 0, 30}));
}

TEST(FlownMission, AStopMeansNoCornerAndADelayAWiderOne) {
  Maker maker;
  maker.add(kWaypoint, {100, 0, 30}).just(kDelay, {5, 0, 0, 0}).add(kWaypoint, {100, 80, 30});
  const FlownMavlink flown = maker.fly();
  EXPECT_EQ(flown.hold[1], 5);
  EXPECT_TRUE(swept(flown, Manoeuvre::leg, {95, 40, 30})) << "from where it waits, 10 m before";
}

TEST(FlownMission, StaysForEverAtAnItemWithoutAutocontinue) {
  const auto refusal = [](std::size_t stays, const MissionRules& rules) {
    Maker maker;
    maker.add(kWaypoint, {50, 0, 30}).just(kSpeed, {1, 5, -1}).add(kWaypoint, {50, 50, 30});
    if (stays < 4) maker.mission().items[stays].goes_on = false;
    return maker.refusal(rules);
  };
  MissionRules ardupilot;
  ardupilot.autopilots = {{.firmware = Firmware::ardupilot}};
  for (const std::size_t stays : {0u, 1u, 2u}) {
    EXPECT_NE(refusal(stays, {}).find("autocontinue"), std::string::npos) << stays;
    EXPECT_EQ(refusal(stays, ardupilot), "") << stays;
  }
  EXPECT_EQ(refusal(3, {}), "");  // nothing follows
  EXPECT_EQ(refusal(4, {}), "");
}

TEST(FlownMission, AShortHoldIsNoRest) {
  Maker maker;
  maker.add(kWaypoint, {100, 0, 30}, {0.1, 6, 0, 0}).add(kWaypoint, {100, 80, 30});
  EXPECT_TRUE(swept(maker.fly(), Manoeuvre::corner, {96, 0, 30}));
  EXPECT_TRUE(swept(maker.fly(), Manoeuvre::leg, {97, 40, 30})) << "from wherever it is by then";
  Maker longer;
  longer.add(kWaypoint, {100, 0, 30}, {4.1, 6, 0, 0}).add(kWaypoint, {100, 80, 30});
  EXPECT_TRUE(longer.fly().sweeps.empty()) << "twice the 2 s that it brakes from 6 m at 3 m/s2";
  Maker here;
  here.add(kWaypoint, {100, 0, 30}, {0.1, 30, 0, 0}).land_here();
  here.mission().items.back().frame = kGlobalRelative;
  EXPECT_NE(here.refusal(), "");
}

TEST(FlownMission, ADelayToATimeOfDayIsADelay) {
  for (const double seconds : {0.0, -1.0}) {
    Maker maker;
    maker.add(kWaypoint, {100, 0, 30}).just(kDelay, {seconds, 12, 30, 0});
    maker.add(kWaypoint, {100, 80, 30});
    EXPECT_TRUE(swept(maker.fly(), Manoeuvre::leg, {95, 40, 30}));
  }
}

TEST(FlownMission, RatesOfClimbAreNoSpeeds) {
  Maker maker;
  maker.just(kSpeed, {3, 0.1, -1, 0}).add(kWaypoint, {100, 0, 30}).add(kWaypoint, {100, 80, 30});
  EXPECT_FALSE(maker.fly().speed);
  EXPECT_TRUE(swept(maker.fly(), Manoeuvre::corner, {106, 0, 30}));
}

TEST(FlownMission, LoitersOnTheSpotOrAnywhereInACircle) {
  Maker spot;
  spot.add(kLoiterTime, {0, 50, 30}, {9, 0, 0, 0}).add(kWaypoint, {50, 50, 30});
  EXPECT_TRUE(spot.fly().sweeps.empty());
  EXPECT_EQ(spot.fly().hold[1], 9);
  Maker wide;
  wide.add(kLoiterTime, {0, 50, 30}, {9, 0, -20, 0}).add(kWaypoint, {80, 50, 30});
  const FlownMavlink flown = wide.fly();
  EXPECT_TRUE(swept(flown, Manoeuvre::hover, {0, 70, 30}));
  EXPECT_TRUE(swept(flown, Manoeuvre::hover, {10, 25, 30})) << "on the way to it";
  EXPECT_TRUE(swept(flown, Manoeuvre::leg, {40, 59, 30})) << "from anywhere in it";
}

TEST(FlownMission, TurnsFromWhereverItComes) {
  Maker maker;
  maker.add(kLoiterTime, {0, 50, 30}, {9, 0, 20, 0}).add(kWaypoint, {80, 50, 30});
  maker.add(kWaypoint, {200, 50, 30});
  const FlownMavlink flown = maker.fly({.acceptance = 10, .speed = 10});
  const Vec3 corner(80, 50, 30);
  const Vec3 aside = (corner - Vec3(0, 30, 30)).normalized();
  const double braking = 10 * 10 / (2 * 3.0);
  EXPECT_TRUE(swept(flown, Manoeuvre::corner, corner - 9.9 * aside));
  EXPECT_TRUE(swept(flown, Manoeuvre::corner, corner + (braking - 10.1) * aside)) << "too fast";
  EXPECT_FALSE(swept(flown, Manoeuvre::corner, corner + (braking - 9.9) * aside));
}

TEST(FlownMission, ClimbsBeforeOrAfterTheWay) {
  Maker maker;
  maker.add(kLoiterToHeight, {100, 0, 80}).add(kWaypoint, {100, 50, 80});
  const FlownMavlink flown = maker.fly();
  EXPECT_TRUE(swept(flown, Manoeuvre::climb, {100, 0, 50}));
  EXPECT_TRUE(swept(flown, Manoeuvre::climb, {50, 0, 50})) << "straight";
  EXPECT_TRUE(swept(flown, Manoeuvre::climb, {50, 0, 30})) << "first across";
  expect_near(flown.path.back(), {100, 50, 80});
}

TEST(FlownMission, SweepsSplines) {
  Maker maker;
  maker.add(kWaypoint, {100, 0, 30}).add(kSplineWaypoint, {100, 90, 30});
  maker.add(kSplineWaypoint, {0, 90, 30});
  const FlownMavlink flown = maker.fly({.acceptance = 0});
  ASSERT_EQ(flown.sweeps.size(), 2u);
  EXPECT_EQ(flown.sweeps[0].part, (FlightPart{3, Manoeuvre::spline}));
  EXPECT_TRUE(holds(flown.sweeps[0].hull, {133, 0, 30})) << "a third of the velocity it comes with";
  EXPECT_TRUE(holds(flown.sweeps[0].hull, {133, 60, 30})) << "on to the next";
}

TEST(FlownMission, ReturnsAtTheHeightThatIsGiven) {
  Maker maker;
  maker.add(kWaypoint, {100, 0, 30}).just(kReturn);
  EXPECT_TRUE(maker.fly().returns);
  const FlownMavlink flown = maker.fly({.return_height = 60});
  EXPECT_FALSE(flown.returns);
  ASSERT_EQ(flown.path.size(), 4u);
  expect_near(flown.path[2], {100, 0, 70});
  expect_near(flown.path[3], {0, 0, 70});
  EXPECT_EQ(flown.ends.landing_on, 10);
  EXPECT_EQ(flown.legs[4], (FlightPart{3, Manoeuvre::landing}));
  EXPECT_TRUE(swept(flown, Manoeuvre::return_home, {90, 0, 50})) << "from 10 m before its end";
  EXPECT_FALSE(swept(flown, Manoeuvre::return_home, {50, 0, 60})) << "100 m away, 60 m high";
  EXPECT_FALSE(flown.speed) << "it returns with a speed of its own";
  EXPECT_TRUE(flown.ends_at_home);
  EXPECT_FALSE(flown.counts_from_flat_ground);
  const FlownMavlink low = maker.fly({.return_height = 5});
  expect_near(low.path[3], {0, 0, 30});
}

TEST(FlownMission, KnowsNoReturnThatAFenceKeepsLow) {
  Maker maker;
  maker.add(kWaypoint, {100, 0, 30}).just(kReturn);
  Autopilot pilot = ardupilot();
  pilot.fence.return_ceiling = 59;
  EXPECT_TRUE(maker.fly({.return_height = 60, .autopilots = {pilot}}).returns);
  EXPECT_FALSE(maker.fly({.return_height = 58, .autopilots = {pilot}}).returns);
}

TEST(FlownMission, MayReturnLowerFromNear) {
  Maker maker;
  maker.add(kWaypoint, {20, 0, 20}, {1, 0.2, 0, 0}).just(kReturn);
  const FlownMavlink flown = maker.fly({.return_height = 40});
  EXPECT_TRUE(swept(flown, Manoeuvre::return_home, {10, 0, 25}));
}

TEST(FlownMission, ReturnsFromWhereSeveralPointsCountAsReached) {
  Maker maker;
  maker.add(kWaypoint, {100, 0, 30}, {0, 30, 0, 0}).add(kWaypoint, {102, 0, 30}, {0, 30, 0, 0});
  maker.just(kReturn);
  EXPECT_TRUE(swept(maker.fly({.return_height = 40}), Manoeuvre::return_home, {72, 0, 40}));
}

TEST(FlownMission, GoesOnFromHomeOrFromItsTakeOff) {
  Maker maker;
  maker.mission().items.clear();
  maker.add(kTakeoff, {100, 0, 30}).add(kWaypoint, {100, 100, 30});
  EXPECT_TRUE(swept(maker.fly(), Manoeuvre::leg, {50, 50, 30}));
}

TEST(FlownMission, MayReturnToTheMissionsOwnLanding) {
  Maker maker;
  maker.add(kWaypoint, {100, 0, 30}).just(kLandingStart).just(kReturn);
  EXPECT_TRUE(maker.fly({.return_height = 60}).returns);
}

TEST(FlownMission, PassesPointsThatAreReachedAtOnce) {
  Maker maker;
  maker.add(kWaypoint, {100, 0, 30}).add(kWaypoint, {103, 6, 30}).add(kWaypoint, {100, 100, 30});
  EXPECT_TRUE(swept(maker.fly(), Manoeuvre::corner, {95, 50, 30})) << "from 10 m before the first";
  EXPECT_FALSE(swept(maker.fly({.acceptance = 3}), Manoeuvre::corner, {97.5, 50, 30}));
}

// The speed of a mission that says 2 m/s first, and then flies a leg behind these items.
std::optional<double> speed_behind(const std::vector<std::pair<int, std::array<double, 4>>>& items,
                                   const char* autopilot) {
  Maker maker;
  maker.just(kSpeed, {1, 2, -1, 0}).add(kWaypoint, {50, 0, 30}, {1, 0.2, 0, 0});
  for (const auto& [command, param] : items) maker.just(command, param);
  maker.add(kWaypoint, {100, 0, 30});
  return maker.fly({.autopilots = *autopilots_of(autopilot)}).speed;
}

TEST(FlownMission, Px4FliesAtItsOwnSpeedBehindOneThatIsNone) {
  for (const double none : {-1.0, 0.0, -2.0}) {
    EXPECT_EQ(speed_behind({{kSpeed, {1, none, -1, 0}}}, "px4"), std::nullopt) << none;
    EXPECT_EQ(speed_behind({{kSpeed, {1, none, -1, 0}}}, "any"), std::nullopt) << none;
    EXPECT_EQ(speed_behind({{kSpeed, {1, none, -1, 0}}}, "ardupilot"), 2) << none;
  }
}

TEST(FlownMission, Px4TakesRatesOfClimbForSpeeds) {
  for (const double type : {2.0, 3.0}) {
    EXPECT_EQ(speed_behind({{kSpeed, {type, 8, -1, 0}}}, "px4"), 8);
    EXPECT_EQ(speed_behind({{kSpeed, {type, 8, -1, 0}}}, "any"), 8);
    EXPECT_EQ(speed_behind({{kSpeed, {type, 8, -1, 0}}}, "ardupilot"), 2);
    EXPECT_EQ(speed_behind({{kSpeed, {type, 1, -1, 0}}}, "any"), 2) << "ArduPilot keeps its speed";
  }
}

TEST(FlownMission, ArdupilotIgnoresSpeedsThatAreTooSmall) {
  const auto speed = [](double said, const char* autopilot) {
    Maker maker;
    maker.just(kSpeed, {1, said, -1, 0}).add(kWaypoint, {50, 0, 30}, {1, 0.2, 0, 0});
    maker.add(kWaypoint, {100, 0, 30});
    return maker.fly({.autopilots = *autopilots_of(autopilot)}).speed;
  };
  EXPECT_EQ(speed(0.1, "ardupilot"), std::nullopt);
  EXPECT_EQ(speed(0.1, "any"), std::nullopt);
  EXPECT_EQ(speed(0.1, "px4"), 0.1);
  EXPECT_EQ(speed(0.3, "ardupilot"), 0.3);
}

TEST(FlownMission, ArdupilotMayNeverRunWhatFollowsACondition) {
  for (const int condition : {kConditionDelay, kConditionDistance, kConditionYaw}) {
    Maker maker;
    maker.just(kSpeed, {1, 12, -1, 0}).add(kWaypoint, {50, 0, 30}, {1, 0.2, 0, 0});
    maker.just(condition, {60, 0, 0, 0}).just(kSpeed, {1, 2, -1, 0}).add(kWaypoint, {90, 0, 30});
    maker.add(kWaypoint, {90, 60, 30}, {0, 0.5, 0, 0});
    const auto out = [&](const char* pilot) {
      const FlownMavlink flown = maker.fly({.autopilots = *autopilots_of(pilot)});
      double most = 0;
      for (const Sweep& sweep : flown.drift.back().sweeps) {
        for (const Vec3& p : sweep.hull) most = std::max(most, p.x());
      }
      return most;
    };
    EXPECT_GT(out("ardupilot"), 90 + 0.12 * 12) << "overshot from 12 m/s";
    EXPECT_LT(out("px4"), 90.47 + 0.12 * 12);
    EXPECT_EQ(speed_behind({{condition, {}}, {kSpeed, {1, 1, -1, 0}}}, "ardupilot"), 2);
    EXPECT_EQ(speed_behind({{condition, {}}, {kSpeed, {1, 9, -1, 0}}}, "ardupilot"), 9);
  }
}

TEST(FlownMission, BrakesFromTheLargestSpeedThatMayBe) {
  Maker maker;
  maker.add(kWaypoint, {50, 0, 30}, {1, 0.2, 0, 0}).just(kSpeed, {1, 15, -1, 0});
  maker.add(kWaypoint, {100, 0, 30}).add(kWaypoint, {100, 80, 30});
  EXPECT_FALSE(maker.fly().speed) << "a leg was flown before any was said";
  EXPECT_TRUE(swept(maker.fly(), Manoeuvre::corner, {127.4, 0, 30}));
}

TEST(FlownMission, MayReturnToRallyPoints) {
  Maker maker;
  maker.add(kWaypoint, {100, 0, 30}, {1, 0.2, 0, 0}).just(kReturn);
  const geom::GeographicFrame earth(kHomeFrame.origin);
  geom::GeodeticPlace rally = earth.place({0, 200, 0});
  rally.height = 15;
  maker.mission().rally = {rally};
  const FlownMavlink flown = maker.fly({.return_height = 60});
  EXPECT_TRUE(swept(flown, Manoeuvre::return_home, {50, 100, 70}));
  EXPECT_TRUE(swept(flown, Manoeuvre::return_home, {0, 200, 25}));
  ASSERT_EQ(flown.rally.size(), 1u);
  expect_near(flown.rally[0], {0, 200, 25});
  EXPECT_TRUE(swept(flown, Manoeuvre::return_home, {50, 100, 85})) << "PX4 adds the return height";
  EXPECT_TRUE(swept(flown, Manoeuvre::return_home, {100, 0, 85}));
  MissionRules rules{.return_height = 60};
  rules.autopilots = {ardupilot()};
  EXPECT_FALSE(swept(maker.fly(rules), Manoeuvre::return_home, {50, 100, 75}));
}

TEST(FlownMission, MayReturnToRallyPointsAboveTheReturnHeight) {
  Maker maker;
  maker.add(kWaypoint, {100, 0, 30}, {1, 0.2, 0, 0}).just(kReturn);
  geom::GeodeticPlace rally = geom::GeographicFrame(kHomeFrame.origin).place({0, 200, 0});
  rally.height = 90;
  maker.mission().rally = {rally};
  const FlownMavlink flown = maker.fly({.return_height = 60});
  EXPECT_TRUE(swept(flown, Manoeuvre::return_home, {100, 0, 100})) << "up where it is";
  EXPECT_TRUE(swept(flown, Manoeuvre::return_home, {50, 100, 100}));
}

TEST(FlownMission, LandsWhereItsPlaceIsKnown) {
  Maker unsaid;
  unsaid.add(kWaypoint, {100, 0, 30}).land_here();
  EXPECT_EQ(unsaid.refusal(),
            "m: item 3: expected the place of the landing, or a waypoint with a hold before it, "
            "found neither: it lands where it is when it takes the waypoint for reached");
  EXPECT_EQ(unsaid.refusal({.acceptance = 0}), "");
  Maker rested;
  rested.add(kWaypoint, {100, 0, 30}, {1, 0.2, 0, 0}).land_here();
  EXPECT_EQ(rested.fly().ends.landing_on, 10);
}

TEST(FlownMission, CountsWhatMovesNothing) {
  Maker maker;
  maker.just(201).just(2000).add(kWaypoint, {100, 0, 30});
  EXPECT_EQ(maker.fly().idle_items, 2u);
}

TEST(FlownMission, ClimbsToTheHeightOfHomeWhereThatIsSaid) {
  Maker maker;
  maker.add(kWaypoint, {100, 0, 40}).add(kLoiterToHeight, {100, 80, 10});
  expect_near(maker.fly(kArduPilot).path.back(), {100, 80, 10});
}

TEST(FlownMission, IsArduPilotsAloneWherePx4DoesNotLoadIt) {
  Maker maker;
  maker.add(kWaypoint, {100, 0, 40}, {1, 0, 0, 0}).add(kSplineWaypoint, {100, 90, 10});
  const FlownMavlink flown = maker.fly();
  EXPECT_EQ(flown.not_for_px4, kSplineWaypoint);
  ASSERT_EQ(flown.drift.size(), 1u);
  EXPECT_EQ(flown.drift[0].autopilot, "ardupilot:4.3-4.7");
  expect_near(flown.path.back(), {100, 90, 40});
  EXPECT_EQ(maker.refusal(kPx4),
            "m: item 3: expected what PX4 flies, found command 82: PX4 loads no mission with it, "
            "and no other autopilot is asked for (--autopilot)");
}

TEST(FlownMission, IsArduPilotsAloneWhereItsTakeOffIsAtZero) {
  Maker maker;
  maker.add(kWaypoint, {100, 0, 40});
  MissionItem& takeoff = maker.mission().items.front();
  takeoff.latitude = takeoff.longitude = 0;
  const FlownMavlink flown = maker.fly();
  EXPECT_EQ(flown.not_for_px4, kTakeoff);
  ASSERT_EQ(flown.drift.size(), 1u);
  EXPECT_EQ(flown.drift[0].autopilot, "ardupilot:4.3-4.7");
  EXPECT_EQ(maker.refusal(kPx4),
            "m: item 1: expected a place, found a take-off at latitude 0, longitude 0: PX4 flies "
            "there when it has climbed");
  takeoff.latitude = takeoff.longitude = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(maker.fly().not_for_px4, 0);
}

TEST(FlownMission, SetsAPayloadDownAndGoesOnFromAbove) {
  Maker maker;
  maker.add(kWaypoint, {100, 0, 40}).add(kPayloadPlace, {100, 80, 70});
  maker.add(kWaypoint, {0, 80, 40});
  const FlownMavlink flown = maker.fly();
  ASSERT_EQ(flown.path.size(), 4u);
  expect_near(flown.path[2], {100, 80, 40});
  EXPECT_TRUE(swept(flown, Manoeuvre::landing, {100, 80, 11}));
  ASSERT_EQ(flown.touches.size(), 1u);
  expect_near(flown.touches[0], {100, 80, 40});
  bool off = false;
  for (const Sweep& sweep : flown.drift[0].sweeps) {
    off = off || (sweep.stands_on == 10.0 && holds(sweep.hull, {100, 80.9, 38}));
  }
  EXPECT_TRUE(off) << "it sinks before what it overshot has decayed";
}

TEST(FlownMission, TakesAuxiliaryFunctionsThatMoveNothing) {
  EXPECT_EQ(Maker().add(kWaypoint, {100, 0, 40}).just(kAuxFunction, {9, 2, 0, 0}).fly().idle_items,
            1u);
  EXPECT_EQ(Maker().add(kWaypoint, {100, 0, 40}).just(kAuxFunction, {70, 2, 0, 0}).refusal(),
            "m: item 3: expected an auxiliary function that moves nothing (9, 19, 28, 30, 34, 35, "
            "36, 66, 67, 102, 166, 167, 168, 169), found 70: others change the mode or stop "
            "motors");
}

TEST(FlownMission, LandsWhereArduPilotStops) {
  Maker maker;
  maker.add(kWaypoint, {100, 0, 30}).just(kLand);
  maker.mission().items.back().frame = kGlobalRelative;
  EXPECT_EQ(maker.fly(kArduPilot).ends.landing_on, 10);
  EXPECT_EQ(maker.refusal(),
            "m: item 3: expected a place, found latitude 0, longitude 0: ArduPilot then stays "
            "where it is, and PX4 flies there: say which of them flies it (--autopilot)");
}

TEST(FlownMission, FliesWhatIsRepeatedForEverTwice) {
  Maker maker;
  maker.add(kWaypoint, {100, 0, 30}).add(kWaypoint, {100, 80, 30}).add(kWaypoint, {0, 80, 30});
  maker.just(kJump, {2, -1, 0, 0});
  const FlownMavlink flown = maker.fly();
  EXPECT_EQ(flown.endless_jumps, 1u);
  ASSERT_EQ(flown.path.size(), 1u + 3u * 3u) << "once, and twice again";
  EXPECT_TRUE(swept(flown, Manoeuvre::corner, {5, 78, 30}))
      << "the turn that each round begins with";
}

}  // namespace
}  // namespace traj
