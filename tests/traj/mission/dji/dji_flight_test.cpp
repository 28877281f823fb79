#include "traj/mission/dji/dji_flight.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/reading.h"
#include "traj/mission/dji/dji_flight_examples.h"

namespace traj {
namespace {

using testing::dji_corner;
using testing::dji_example;
using testing::fly;
using testing::kEast;
using testing::kOrigin;
using testing::kSouth;

void expect_path(const FlownDji& flown, const geom::Polyline& expected) {
  ASSERT_EQ(flown.path.size(), expected.size());
  ASSERT_EQ(flown.hold.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_LT((flown.path[i] - expected[i]).norm(), 0.1) << i << ": " << flown.path[i].transpose();
  }
}

TEST(FlownDji, RisesToTheFirstWaypointGoesThereAndOn) {
  const FlownDji flown = fly(dji_example());
  expect_path(flown, {{0, kSouth, 40}, {0, 0, 40}, {kEast, 0, 45}});
  EXPECT_EQ(flown.hold, (std::vector<double>{0, 1.5, 0}));
  EXPECT_EQ(flown.ends.takeoff_from, 10);
  EXPECT_FALSE(flown.ends.landing_on);
  EXPECT_EQ(flown.speed, 9) << "on the way to the first waypoint";
  EXPECT_TRUE(flown.home_is_said);
  EXPECT_FALSE(flown.lands_below || flown.returns || flown.returns_at);
}

TEST(FlownDji, ClimbsNoFasterThanTheAircraftCan) {
  DjiMission m = dji_example();
  EXPECT_EQ(fly(m).climb, 6);
  m.aircraft = {99, 1};
  EXPECT_EQ(fly(m).climb, 10);
  EXPECT_EQ(fly(m).descent, 8);
  m.aircraft = {1, 0};
  EXPECT_EQ(fly(m).climb, 0) << "nobody says how fast it is";
}

TEST(FlownDji, CountsFromTheGroundThatIsGivenWhereTheMapsHeightIsNotKnown) {
  const MissionFrame unknown{{47, 8, 0}, 0, false};
  DjiMission m = dji_example();
  const auto refusal = [&](const DjiRules& rules) {
    return support::refusal_of([&] { flown_dji(m, unknown, rules, "m.kmz"); });
  };
  EXPECT_EQ(refusal({}),
            "m.kmz:7: heights count from the take-off, and the map does not say how high above the "
            "ellipsoid its z = 0 is: give the map's z of the ground there (--ground)");
  const FlownDji flown = flown_dji(m, unknown, {3, {}}, "m.kmz");
  EXPECT_EQ(flown.ends.takeoff_from, 3);
  EXPECT_NEAR(flown.path.back().z(), 38, 1e-9);
  m.waylines[0].heights = DjiHeights::ellipsoid;
  EXPECT_EQ(refusal({3, {}}),
            "m.kmz:7: expected heights above the take-off, found one above the ellipsoid, and the "
            "map does not say how high above it its z = 0 is: give --origin "
            "latitude,longitude,height");
}

TEST(FlownDji, RisesToTheSecurityHeightFirst) {
  DjiMission m = dji_example();
  m.security_height = 50;
  expect_path(fly(m), {{0, kSouth, 60}, {0, 0, 60}, {0, 0, 40}, {kEast, 0, 45}});
  m.approach = DjiApproach::point_to_point;
  expect_path(fly(m), {{0, kSouth, 60}, {0, 0, 60}, {0, 0, 40}, {kEast, 0, 45}});
  m.security_height = 5;
  expect_path(fly(m), {{0, kSouth, 15}, {0, 0, 40}, {kEast, 0, 45}});
}

TEST(FlownDji, TakesOffBelowTheFirstWaypointWhereNothingElseIsSaid) {
  DjiMission m = dji_example();
  m.takeoff.reset();
  EXPECT_EQ(support::refusal_of([&] { fly(m); }),
            "m.kmz:7: heights count from the take-off, and the file does not say where that is: "
            "give the map's z of the ground there (--ground)");
  const FlownDji flown = fly(m, {12, {}});
  expect_path(flown, {{0, 0, 42}, {kEast, 0, 47}});
  EXPECT_FALSE(flown.home_is_said);
  EXPECT_LT((*flown.home - Vec3(0, 0, 12)).norm(), 1e-9);
  EXPECT_EQ(flown.home_place, (geom::GeodeticPlace{47, 8, 402}));
  EXPECT_EQ(flown.speed, 4) << "that of the last waypoint leads nowhere";
}

TEST(FlownDji, TheGroundThatIsGivenGoesBeforeTheFiles) {
  const FlownDji flown = fly(dji_example(), {12, {}});
  EXPECT_EQ(flown.ends.takeoff_from, 12);
  expect_path(flown, {{0, kSouth, 42}, {0, 0, 42}, {kEast, 0, 47}});
}

TEST(FlownDji, HeightsAboveTheEllipsoidDoNotCountFromTheTakeOff) {
  DjiMission m = dji_example();
  m.waylines[0].heights = DjiHeights::ellipsoid;
  m.waylines[0].waypoints[0].height = 440;
  m.waylines[0].waypoints[1].height = 450;
  expect_path(fly(m), {{0, kSouth, 50}, {0, 0, 50}, {kEast, 0, 60}});
}

TEST(FlownDji, GoesOnFromWaylineToWayline) {
  DjiMission m = dji_example();
  m.waylines.push_back({1, DjiHeights::above_takeoff, {{47, 8, 60, 4, 0, 9}}});
  m.waylines.push_back({2, DjiHeights::above_takeoff, {{47, 8.001, 20, 4, 0, 9}}});
  expect_path(fly(m), {{0, kSouth, 40},
                       {0, 0, 40},
                       {kEast, 0, 45},
                       {kEast, 0, 70},
                       {0, 0, 70},
                       {kEast, 0, 70},
                       {kEast, 0, 30}});
  m.approach = DjiApproach::point_to_point;
  expect_path(fly(m), {{0, kSouth, 30}, {0, 0, 40}, {kEast, 0, 45}, {0, 0, 70}, {kEast, 0, 30}});
}

TEST(FlownDji, ReturnsAtTheHeightThatTheFileSays) {
  DjiMission m = dji_example();
  m.finish = DjiFinish::go_home;
  EXPECT_TRUE(fly(m).returns) << "no height";
  m.return_height = 60;
  const FlownDji flown = fly(m);
  EXPECT_FALSE(flown.returns);
  EXPECT_TRUE(flown.ends_at_home);
  EXPECT_EQ(flown.returns_at, 60);
  EXPECT_FALSE(flown.speed) << "the return's is the aircraft's own";
  EXPECT_EQ(flown.ends.landing_on, 10);
  expect_path(flown,
              {{0, kSouth, 40}, {0, 0, 40}, {kEast, 0, 45}, {kEast, 0, 70}, {0, kSouth, 70}});
  m.return_height = 20;
  expect_path(fly(m), {{0, kSouth, 40}, {0, 0, 40}, {kEast, 0, 45}, {0, kSouth, 45}});
}

TEST(FlownDji, ReturnsAtTheHeightThatIsGivenWhereTheFileSaysNone) {
  DjiMission m = dji_example();
  m.finish = DjiFinish::go_home;
  const FlownDji flown = fly(m, {{}, 60});
  EXPECT_FALSE(flown.returns);
  EXPECT_EQ(flown.returns_at, 60);
}

TEST(FlownDji, RefusesAReturnHeightOtherThanTheFiles) {
  DjiMission m = dji_example();
  m.return_height = 70;
  EXPECT_EQ(fly(m, {{}, 70}).return_height, 70);
  EXPECT_EQ(support::refusal_of([&] {
              fly(m, {{}, 60});
            }),
            "m.kmz: expected globalRTHHeight 60, as --return-height says, found 70: the "
            "aircraft returns at the file's height: leave the option out");
}

TEST(FlownDji, AReturnFromNearHomeMayRiseOrNot) {
  DjiMission m = dji_example();
  m.finish = DjiFinish::go_home;
  m.return_height = 60;
  EXPECT_TRUE(fly(m).sweeps.empty());
  m.takeoff = geom::GeodeticPlace{47, 8.0005, 400};
  const FlownDji flown = fly(m);
  EXPECT_FALSE(flown.returns);
  ASSERT_EQ(flown.sweeps.size(), 1u);
  EXPECT_EQ(flown.sweeps[0].part, (FlightPart{1, Manoeuvre::return_home}));
  ASSERT_EQ(flown.sweeps[0].hull.size(), 4u);
  EXPECT_LT((flown.sweeps[0].hull[0] - Vec3(kEast, 0, 45)).norm(), 0.1);
  EXPECT_LT((flown.sweeps[0].hull[2] - Vec3(kEast / 2, 0, 45)).norm(), 0.1);
  EXPECT_LT((flown.sweeps[0].hull[3] - Vec3(kEast / 2, 0, 70)).norm(), 0.1);
  m.return_height = 30;
  EXPECT_TRUE(fly(m).sweeps.empty()) << "it is higher already";
}

TEST(FlownDji, AReturnFromAboveHomeIsNotKnown) {
  DjiMission m = dji_example();
  m.finish = DjiFinish::go_home;
  m.return_height = 60;
  m.takeoff = geom::GeodeticPlace{47, 8.0008, 400};
  EXPECT_TRUE(fly(m).returns);
  m.finish = DjiFinish::first_waypoint;
  EXPECT_TRUE(fly(m).returns) << "nor is that to the first waypoint";
}

TEST(FlownDji, EachLegHasItsWaypoint) {
  DjiMission m = dji_example();
  m.finish = DjiFinish::go_home;
  m.return_height = 60;
  m.security_height = 50;
  EXPECT_EQ(fly(m).legs, (std::vector<FlightPart>{{0, Manoeuvre::takeoff},
                                                  {0, Manoeuvre::leg},
                                                  {0, Manoeuvre::leg},
                                                  {1, Manoeuvre::leg},
                                                  {1, Manoeuvre::climb},
                                                  {1, Manoeuvre::return_home},
                                                  {1, Manoeuvre::landing}}));
}

void expect_hull(const FlownDji& flown, const std::vector<Vec3>& expected) {
  ASSERT_EQ(flown.sweeps.size(), 1u);
  EXPECT_EQ(flown.sweeps[0].part, (FlightPart{1, Manoeuvre::corner}));
  ASSERT_EQ(flown.sweeps[0].hull.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_LT((flown.sweeps[0].hull[i] - expected[i]).norm(), 0.1)
        << i << ": " << flown.sweeps[0].hull[i].transpose();
  }
}

TEST(FlownDji, ACoordinatedTurnStaysInItsTriangle) {
  expect_hull(fly(dji_corner(DjiTurn::early, 10)),
              {{kEast - 10, 0, 40}, {kEast, 0, 40}, {kEast, 10, 40}});
  EXPECT_TRUE(fly(dji_corner(DjiTurn::stop, 0)).sweeps.empty());
}

TEST(FlownDji, ATurnThroughItsWaypointMaySwingWide) {
  const FlownDji level = fly(dji_corner(DjiTurn::through, 10));
  expect_hull(level, {{kEast - 10, -10, 40},
                      {kEast - 10, -10, 40},
                      {kEast - 10, 10, 40},
                      {kEast - 10, 10, 40},
                      {kEast + 10, -10, 40},
                      {kEast + 10, -10, 40},
                      {kEast + 10, 10, 40},
                      {kEast + 10, 10, 40}});
  const FlownDji rising = fly(dji_corner(DjiTurn::through, 10, 50));
  const auto& hull = rising.sweeps.at(0).hull;
  const double before = 20 * 10 / std::hypot(kEast, 20);
  const double behind = 20 * 10 / std::hypot(kSouth, 20);
  EXPECT_NEAR(hull[0].z(), 60 - before - (before + behind), 0.1);
  EXPECT_NEAR(hull[1].z(), 60 + behind + (before + behind), 0.1);
}

TEST(FlownDji, TurnsMustNotMeet) {
  DjiMission m = dji_corner(DjiTurn::early, 70);
  EXPECT_EQ(support::refusal_of([&] { fly(m); }), "");
  m.waylines[0].waypoints[0].damping = 7;
  m.waylines[0].waypoints[0].turn = DjiTurn::early;
  EXPECT_EQ(support::refusal_of([&] { fly(m); }),
            "m.kmz: expected turns that do not meet, found a leg of 76.06 m, of which turns take "
            "77 m (waypointTurnDampingDist)");
  EXPECT_NE(support::refusal_of([&] { fly(dji_corner(DjiTurn::early, 77)); }), "");
}

TEST(FlownDji, TurnsMustNotMeetBetweenWaylinesEither) {
  DjiMission m = dji_corner(DjiTurn::stop, 0);
  m.approach = DjiApproach::point_to_point;
  DjiWaypoint last{47, 8.001, 35, 6, 0, 8};
  m.waylines[0].waypoints[2] = last;
  m.waylines[0].waypoints[2].turn = DjiTurn::early;
  m.waylines[0].waypoints[2].damping = 40;
  m.waylines[0].waypoints[1] = {47.002, 8.001, 35, 4};
  m.waylines.push_back({1, DjiHeights::above_takeoff, {{47, 8, 35, 4}, {47.002, 8, 35, 4}}});
  m.waylines[1].waypoints[0].turn = DjiTurn::early;
  m.waylines[1].waypoints[0].damping = 30;
  EXPECT_EQ(support::refusal_of([&] { fly(m); }), "");
  m.waylines[1].waypoints[0].damping = 37;
  EXPECT_NE(support::refusal_of([&] { fly(m); }), "") << "40 m and 37 m of 76 m";
}

TEST(FlownDji, TurnsAtTheFirstWaypointBeginOnTheWayThere) {
  DjiMission m = dji_corner(DjiTurn::stop, 0);
  m.waylines[0].waypoints[0].turn = DjiTurn::early;
  m.waylines[0].waypoints[0].damping = 5;
  const FlownDji flown = fly(m);
  ASSERT_EQ(flown.sweeps.size(), 1u);
  EXPECT_LT((flown.sweeps[0].hull[0] - Vec3(0, -5, 40)).norm(), 0.1);
  EXPECT_LT((flown.sweeps[0].hull[2] - Vec3(5, 0, 40)).norm(), 0.1);
}

TEST(FlownDji, LandsOnWhatIsBelow) {
  DjiMission m = dji_example();
  m.finish = DjiFinish::land;
  EXPECT_TRUE(fly(m).lands_below);
}

TEST(FlownDji, AircraftThatDoNotRiseFirstNeedAHighFirstWaypoint) {
  DjiMission m = dji_example();
  for (const int type : {60, 89}) {
    m.aircraft.type = type;
    m.security_height = 30;
    EXPECT_EQ(support::refusal_of([&] { fly(m); }), "");
    m.security_height = 31;
    EXPECT_TRUE(support::says(support::refusal_of([&] { fly(m); }),
                              "does not rise to takeOffSecurityHeight"));
    m.security_height = 30;
    m.approach = DjiApproach::point_to_point;
    EXPECT_NE(support::refusal_of([&] { fly(m); }), "");
    m.approach = DjiApproach::safely;
  }
}

TEST(FlownDji, PlacesFarFromTheMapAreRefused) {
  DjiMission m = dji_example();
  m.waylines[0].waypoints[1].longitude = 151;
  EXPECT_EQ(support::refusal_of([&] { fly(m); }),
            "m.kmz:8: expected a place near the origin 47 8, found 47 151");
  m = dji_example();
  m.takeoff->latitude = -33;
  EXPECT_EQ(support::refusal_of([&] { fly(m); }),
            "m.kmz: expected a place near the origin 47 8, found -33 8");
}

}  // namespace
}  // namespace traj
