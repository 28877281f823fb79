#include "traj/mission/judge/judge.h"

#include <gtest/gtest.h>

#include "traj/mission/formats/setpoints.h"
#include "traj/mission/formats/tello.h"
#include "traj/scenes.h"

namespace traj {
namespace {

using testing::scene_of;

// A block with a roof at 10 m, and another that hangs from 20 m up.
geom::CollisionScene yard() {
  return scene_of({{{0, 0, 0}, {10, 10, 10}}, {{20, 0, 20}, {30, 10, 30}}});
}

FlownMission path(geom::Polyline points) {
  FlownMission flown;
  flown.path = std::move(points);
  return flown;
}

TEST(Judge, LandsOnlyOnWhatIsAsHighAsTheFileSays) {
  FlownMission flown = path({{40, 5, 35}, {5, 5, 35}});
  flown.ends.landing_on = 10;
  EXPECT_TRUE(judge(yard(), {flown}, {}).ok) << "on the roof";
  flown.ends.landing_on = 15;
  const CheckResult above = judge(yard(), {flown}, {});
  EXPECT_EQ(above.reason, Reason::landing) << "it would sink to the roof";
  EXPECT_NEAR(above.worst, 5, 1e-9);
  EXPECT_EQ(above.place.z(), 10);
  const geom::CollisionScene wide(yard().map(), {"box", Vec3(0.5, 0.5, 0.2)}, 0);
  flown.path.back() = {9.6, 5, 35};
  flown.ends.landing_on = 10;
  EXPECT_EQ(judge(wide, {flown}, {}).reason, Reason::landing) << "on the roof's edge";
  flown.ends.landing_on.reset();
  flown.lands_below = true;
  EXPECT_EQ(judge(wide, {flown}, {}).reason, Reason::landing) << "whoever says so";
  flown.path.back().x() = 9.4;
  EXPECT_TRUE(judge(wide, {flown}, {}).ok);
}

TEST(Judge, HoldsWhereTheAutopilotMayBeWithoutTheMargin) {
  FlownMission flown = path({{-5, -5, 15}, {-5, 20, 15}});
  flown.drift = {{"px4:1.17", {{{{-5, -5, 15}, {-5, 20, 15}}, {3, Manoeuvre::leg}}}, {3, 3, 1}}};
  EXPECT_TRUE(judge(yard(), {flown}, {}).ok);
  flown.drift[0].sweeps.push_back({{{-5, 5, 15}, {2, 5, 15}}, {4, Manoeuvre::overshoot}});
  EXPECT_TRUE(judge(yard(), {flown}, {}).ok) << "above the roof";
  flown.drift[0].around.z() = 6;
  const CheckResult result = judge(yard(), {flown}, {});
  EXPECT_EQ(result.reason, Reason::collision);
  EXPECT_EQ(result.strayed, "px4:1.17");
  EXPECT_EQ(result.part, (FlightPart{4, Manoeuvre::overshoot}));
  flown.drift[0].around.z() = 1;
  EXPECT_EQ(judge(yard(), {flown, Vec3(0, 0, 5)}, {}).reason, Reason::collision);
}

TEST(Judge, WhatItStandsOnIsNotInItsWay) {
  FlownMission flown = path({{5, 5, 35}, {40, 5, 35}});
  flown.ends.takeoff_from = 10;
  flown.drift = {{"px4", {{{{5, 5, 10}, {5, 5, 35}}, {1, Manoeuvre::takeoff}, 10.0}}, {1, 1, 1}}};
  EXPECT_TRUE(judge(yard(), {flown}, {}).ok);
  flown.drift[0].sweeps[0].stands_on = 9.5;
  EXPECT_EQ(judge(yard(), {flown}, {}).reason, Reason::collision);
}

TEST(Judge, NavigationAndTrackingMakeTheVehicleLarger) {
  Flown flown{path({{-5, -5, 5}, {-5, 20, 5}})};
  const double room = 5 - yard().half().x();
  flown.navigation = {room - 0.01, 0, 0};
  EXPECT_TRUE(judge(yard(), flown, {}).ok);
  flown.navigation.x() = room + 0.01;
  const CheckResult result = judge(yard(), flown, {});
  EXPECT_EQ(result.reason, Reason::collision);
  EXPECT_EQ(result.strayed, "navigation and tracking");
}

TEST(Judge, TheAutopilotKeepsItsRatesOfClimb) {
  FlownMission flown = path({{40, 40, 5}, {40, 40, 25}, {80, 40, 25}});
  flown.speed = 8;
  EXPECT_EQ(judge(yard(), {flown}, {{Limit::vertical_speed, 4}}).reason,
            broken(Limit::vertical_speed));
  flown.climb = 3;
  flown.descent = 1.5;
  const CheckResult result = judge(yard(), {flown}, {{Limit::vertical_speed, 4}});
  EXPECT_TRUE(result.ok);
  EXPECT_EQ(result.largest[Limit::vertical_speed]->value, 3);
  EXPECT_EQ(result.largest[Limit::speed]->value, 8);
}

TEST(Judge, LegsThatFollowWhatIsBelowRiseAndSinkAsTheyMay) {
  FlownLegs flown;
  flown.path = {{5, 5, 5}, {5, 9, 8}};  // the middle of its band: 3 m up in 4 m
  flown.leg_band = {1};
  flown.speed = 5;
  flown.climb = 2;
  flown.descent = 1.5;
  const auto largest = [&](Limit limit) {
    return judge(yard(), {flown}, {}).largest[limit]->value;
  };
  EXPECT_EQ(largest(Limit::horizontal_speed), 5) << "it does not slow down to follow";
  EXPECT_NEAR(largest(Limit::vertical_speed), 4, 1e-12) << "as fast again as it climbs";
  EXPECT_NEAR(largest(Limit::speed), std::hypot(5, 4), 1e-12);
  flown.climb_holds_in_band = true;
  EXPECT_EQ(largest(Limit::vertical_speed), 2);
  EXPECT_NEAR(largest(Limit::speed), std::hypot(5, 2), 1e-12);
}

TEST(Judge, LooksAtTheAscentAndTheDescent) {
  FlownMission flown = path({{25, 5, 35}, {40, 5, 35}});
  EXPECT_TRUE(judge(yard(), {flown}, {}).ok);
  flown.ends.takeoff_from = 0;
  const CheckResult result = judge(yard(), {flown}, {});
  EXPECT_EQ(result.reason, Reason::collision);
  EXPECT_NEAR(result.place.x(), 25, 1e-6);
  EXPECT_LT(result.time, 1) << "leg 0";
  flown.ends.takeoff_from = 30;
  EXPECT_TRUE(judge(yard(), {flown}, {}).ok) << "what stands on a roof touches it";
  std::swap(flown.path[0], flown.path[1]);
  flown.ends = {{}, 0};
  EXPECT_EQ(judge(yard(), {flown}, {}).reason, Reason::collision);
  flown.ends = {36, {}};
  EXPECT_EQ(judge(yard(), {flown}, {}).reason, Reason::takeoff) << "below the ground";
}

TEST(Judge, TakesOffFromTheGround) {
  FlownMission flown = path({{40, 5, 35}, {80, 5, 35}});
  flown.ends.takeoff_from = 0.9;
  EXPECT_TRUE(judge(yard(), {flown}, {}).ok);
  flown.ends.takeoff_from = 20;
  const CheckResult result = judge(yard(), {flown}, {});
  EXPECT_EQ(result.reason, Reason::takeoff_ground);
  EXPECT_NEAR(result.worst, 20, 1e-9);
  EXPECT_EQ(result.place, Vec3(40, 5, 20));
  EXPECT_EQ(judge(yard(), {static_cast<FlownLegs>(flown)}, {}).reason, Reason::takeoff_ground)
      << "a script has no home";
}

TEST(Judge, HeightsThatCountFromHomeCountFromTheGround) {
  FlownMission flown = path({{40, 5, 35}, {80, 5, 35}});
  flown.home = Vec3(40, 5, 20);
  EXPECT_EQ(judge(yard(), {flown}, {}).reason, Reason::takeoff_ground) << "without a take-off";
  flown.home = Vec3(40, 5, 0);
  EXPECT_TRUE(judge(yard(), {flown}, {}).ok);
  flown.home = Vec3(40, 5, yard().map().spec().bounds.min.z() - 20);
  EXPECT_EQ(judge(yard(), {flown}, {}).reason, Reason::takeoff_ground) << "below the map";
  flown.home = Vec3(-4000, 5, 20);
  EXPECT_TRUE(judge(yard(), {flown}, {}).ok) << "the map does not reach there";
}

TEST(Judge, LandsOnWhatIsBelow) {
  FlownMission flown = path({{40, 5, 35}, {5, 5, 35}});
  flown.lands_below = true;
  EXPECT_TRUE(judge(yard(), {flown}, {}).ok);
  const auto way = whole_way(yard(), flown);
  ASSERT_TRUE(way);
  ASSERT_EQ(way->size(), 3u);
  EXPECT_NEAR(way->back().z(), 10 + yard().half().z(), 0.01) << "on the roof";
  flown.path.back() = {15, 5, 35};
  EXPECT_NEAR(whole_way(yard(), flown)->back().z(),
              yard().map().spec().bounds.min.z() + yard().half().z(), 0.01)
      << "between the blocks";
  flown.path_stray = {5, 0, 0};
  EXPECT_FALSE(judge(yard(), {flown}, {}).ok) << "where it may be off";
}

TEST(Judge, LandsOnLevelGroundOnlyWithoutAMissionToo) {
  FlownLegs flown = path({{40, 5, 35}, {5, 5, 35}});
  flown.lands_below = true;
  EXPECT_TRUE(judge(yard(), {flown}, {}).ok);
  flown.path_stray.x() = 6;
  const CheckResult edge = judge(yard(), {flown}, {});
  EXPECT_EQ(edge.reason, Reason::landing);
  EXPECT_FALSE(edge.part) << "it has no items";
}

TEST(Judge, LandsAtRallyPointsOnTheGroundOfHome) {
  FlownMission flown = path({{40, 5, 35}, {45, 5, 35}});
  const double ground = yard().map().spec().bounds.min.z();
  flown.home = Vec3(40, 5, ground);
  flown.rally = {{15, 5, 15}};
  EXPECT_TRUE(judge(yard(), {flown}, {}).ok);
  flown.rally = {{15, 5, 15}, {5, 5, 15}};
  const CheckResult roof = judge(yard(), {flown}, {});
  EXPECT_EQ(roof.reason, Reason::return_home);
  EXPECT_EQ(roof.place, Vec3(5, 5, 10)) << "on the block";
  flown.rally = {{25, 5, 40}};
  EXPECT_EQ(judge(yard(), {flown}, {}).reason, Reason::return_home) << "on what hangs there";
  flown.rally = {{20 - yard().half().x() / 2, 5, 40}};
  EXPECT_EQ(judge(yard(), {flown}, {}).reason, Reason::return_home) << "past its edge";
}

TEST(Judge, KnowsTheSpeedsOfLegs) {
  FlownMission flown = path({{40, 0, 5}, {40, 30, 45}});
  flown.speed = 5;
  Limits limits;
  limits[Limit::speed] = 5;
  EXPECT_TRUE(judge(yard(), {flown}, limits).ok);
  limits[Limit::speed] = 4.9;
  EXPECT_EQ(judge(yard(), {flown}, limits).reason, broken(Limit::speed));
  limits[Limit::speed].reset();
  limits[Limit::vertical_speed] = 3.9;
  EXPECT_EQ(judge(yard(), {flown}, limits).reason, broken(Limit::vertical_speed));
  limits[Limit::vertical_speed] = 4;
  limits[Limit::horizontal_speed] = 2.9;
  EXPECT_EQ(judge(yard(), {flown}, limits).reason, broken(Limit::horizontal_speed));
}

TEST(Judge, KnowsHowFarATelloMayGo) {
  const auto reason = [](const Vec3& to, double airborne) {
    FlownMission flown = path({{40, 0, 1}, to});
    flown.ends.takeoff_from = 0;
    flown.envelope = kTelloEnvelope;
    flown.airborne = airborne;
    return judge(yard(), {flown}, {}).reason;
  };
  EXPECT_EQ(reason({40, 95, 30}, 780), Reason::none);
  EXPECT_EQ(reason({40, 20, 30.01}, 780), Reason::ceiling);
  EXPECT_EQ(reason({40, 100, 2}, 780), Reason::range);
  EXPECT_EQ(reason({40, 20, 2}, 780.1), Reason::endurance);
}

TEST(Judge, HoldsSetpointsToTheLimits) {
  const State a{{40, 0, 5}, {3, 0, 0}, {0, 0, 1}};
  const State b{{43, 0, 5}, {3, 0, 4}, {2, 0, 0}};
  FlownSetpoints flown;
  flown.setpoints = {{0, a, 0, 0}, {1, b, 0, 0}};
  Limits limits;
  limits[Limit::speed] = 5;
  EXPECT_TRUE(judge(yard(), {flown}, limits).ok);
  EXPECT_EQ(judge(yard(), {flown}, limits).largest[Limit::speed]->value, 5);
  limits[Limit::speed] = 4.9;
  const CheckResult result = judge(yard(), {flown}, limits);
  EXPECT_EQ(result.reason, broken(Limit::speed));
  EXPECT_EQ(result.time, 1);
  limits = {};
  limits[Limit::tilt] = 0.2;
  EXPECT_EQ(judge(yard(), {flown}, limits).reason, broken(Limit::tilt));
  flown.setpoints[1].state.position = {5, 5, 5};
  EXPECT_EQ(judge(yard(), {flown}, {}).reason, Reason::collision);
}

// Rows of a table, flown; the reason of the refusal.
Reason reason_of(const std::vector<Setpoint>& setpoints, const Limits& limits) {
  FlownSetpoints flown;
  flown.setpoints = setpoints;
  return judge(yard(), {flown}, limits).reason;
}

TEST(Judge, HoldsWhatLeadsFromSetpointToSetpointToTheLimits) {
  const Vec3 p(40, 0, 5);
  const Vec3 none = Vec3::Zero();
  const std::vector<Setpoint> jerky = {{0, {p, none, {3, 0, 0}}, 0, 0},
                                       {0.1, {p, none, {-3, 0, 0}}, 0, 0}};
  EXPECT_EQ(reason_of(jerky, {{Limit::jerk, 59}}), broken(Limit::jerk));
  EXPECT_EQ(reason_of(jerky, {{Limit::jerk, 60}}), Reason::none);
  // |f x f'| / |f|^2 where f is upright: 60 / 9.80665 rad/s.
  EXPECT_EQ(reason_of(jerky, {{Limit::body_rate, 6.1}}), broken(Limit::body_rate));
  EXPECT_EQ(reason_of(jerky, {{Limit::body_rate, 6.12}}), Reason::none);
  const std::vector<Setpoint> quick = {{0, {p}, 0, 0}, {2, {p + Vec3(3, 0, 4)}, 0, 0}};
  EXPECT_EQ(reason_of(quick, {{Limit::speed, 2.4}}), broken(Limit::speed));
  EXPECT_EQ(
      reason_of(quick,
                {{Limit::speed, 2.5}, {Limit::horizontal_speed, 1.5}, {Limit::vertical_speed, 2}}),
      Reason::none);
  EXPECT_EQ(reason_of(quick, {{Limit::horizontal_speed, 1.4}}), broken(Limit::horizontal_speed));
  EXPECT_EQ(reason_of(quick, {{Limit::vertical_speed, 1.9}}), broken(Limit::vertical_speed));
  const std::vector<Setpoint> rush = {{0, {p}, 0, 0}, {1, {p, {6, 0, 0}}, 0, 0}};
  EXPECT_EQ(reason_of(rush, {{Limit::acceleration, 5.9}}), broken(Limit::acceleration));
  EXPECT_EQ(reason_of(rush, {{Limit::tilt, 0.5}}), broken(Limit::tilt));
  EXPECT_EQ(reason_of(rush, {{Limit::thrust, 11}}), broken(Limit::thrust));
  EXPECT_EQ(reason_of(rush, {{Limit::acceleration, 6}}), Reason::none);
  const std::vector<Setpoint> turn = {{0, {p}, 3.1, 0}, {1, {p}, -3.1, 0}};
  EXPECT_EQ(reason_of(turn, {{Limit::yaw_rate, 0.08}}), broken(Limit::yaw_rate))
      << "across half a turn: 0.083";
  EXPECT_EQ(reason_of(turn, {{Limit::yaw_rate, 0.09}}), Reason::none);
}

TEST(Judge, HoldsNoSampledTrajectoryToMoreThanItsOwnLimits) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Trajectory t = testing::random_trajectory(seed);
    const auto far = scene_of({}, {Vec3(-1e4, -1e4, -1e4), Vec3(1e4, 1e4, 1e4)});
    const CheckResult of = check(far, t, Limits{});
    const Limits limits{{Limit::speed, of.largest[Limit::speed]->value},
                        {Limit::acceleration, of.largest[Limit::acceleration]->value},
                        {Limit::jerk, of.largest[Limit::jerk]->value},
                        {Limit::horizontal_speed, of.largest[Limit::horizontal_speed]->value},
                        {Limit::vertical_speed, of.largest[Limit::vertical_speed]->value},
                        {Limit::thrust, of.largest[Limit::thrust]->value}};
    for (const double rate : {1.0, 7.0, 50.0, 1000.0}) {
      FlownSetpoints flown;
      flown.setpoints = setpoints(t, rate);
      EXPECT_EQ(judge(far, {flown}, limits).reason, Reason::none) << seed << " at " << rate;
    }
  }
}

TEST(Judge, SaysWhatItDoesNotMeasure) {
  FlownMission flown = path({{40, 0, 5}, {40, 30, 5}});
  const Limits limits{{Limit::speed, 5},  {Limit::acceleration, 3}, {Limit::jerk, 9},
                      {Limit::tilt, 0.5}, {Limit::body_rate, 1},    {Limit::yaw_rate, 1}};
  const CheckResult unsaid = judge(yard(), {flown}, limits);
  EXPECT_FALSE(unsaid.largest[Limit::speed] || unsaid.largest[Limit::jerk] ||
               unsaid.largest[Limit::tilt] || unsaid.jumps);
  EXPECT_EQ(not_measured(unsaid, limits),
            (std::vector<Limit>{Limit::speed, Limit::acceleration, Limit::jerk, Limit::tilt,
                                Limit::body_rate, Limit::yaw_rate}));
  flown.speed = 5;
  const CheckResult said = judge(yard(), {flown}, limits);
  EXPECT_EQ(said.largest[Limit::speed]->value, 5);
  EXPECT_EQ(not_measured(said, {{Limit::speed, 5}}), std::vector<Limit>{});
  flown.returns = true;
  EXPECT_EQ(judge(yard(), {flown}, {}).reason, Reason::return_home);
}

TEST(Judge, LooksBesideAPathAsFarAsItMayBeOff) {
  FlownMission flown = path({{10.005, -5, 5}, {10.005, 15, 5}});
  EXPECT_TRUE(judge(yard(), {flown}, {}).ok);
  flown.path_stray = {0.01, 0.01, 0.01};
  const CheckResult result = judge(yard(), {flown}, {});
  EXPECT_EQ(result.reason, Reason::collision);
  EXPECT_EQ(result.box, 0u);
  EXPECT_EQ(result.clearance->value, 0);
  flown.path = {{60, 0, 99.995}, {70, 0, 50}};
  EXPECT_EQ(judge(yard(), {flown}, {}).reason, Reason::bounds);
  flown.path = {{15, 5, 12}, {40, 5, 12}};
  flown.ends = {0, 0};
  EXPECT_TRUE(judge(yard(), {flown}, {}).ok) << "it stands on the ground, exactly";
}

}  // namespace
}  // namespace traj
