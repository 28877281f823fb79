#include "traj/mission/dji/dji_mission.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mission/dji/surface_heights.h"
#include "support/reading.h"
#include "traj/flight/vehicle_profile.h"
#include "traj/mission/mavlink/examples.h"

namespace traj {
namespace {

using testing::kFrame;
using testing::kPoints;

constexpr geom::GeodeticOrigin kOrigin{47, 8, 390};

// Waypoints about 76 m apart, 30 and 35 m above the take-off, which is 100 m south of the first.
DjiMission example() {
  DjiMission m;
  m.transit_speed = 9;
  m.takeoff = geom::GeodeticPlace{46.9991, 8, 400};
  m.waylines = {{0, DjiHeights::above_takeoff, {{47, 8, 30, 4, 1.5, 7}, {47, 8.001, 35, 6, 0, 8}}}};
  return m;
}

FlownDji fly(const DjiMission& mission, const DjiRules& rules = {}) {
  return flown_dji(mission, {kOrigin, 0}, rules, "m.kmz");
}

void expect_path(const FlownDji& flown, const geom::Polyline& expected) {
  ASSERT_EQ(flown.path.size(), expected.size());
  ASSERT_EQ(flown.hold.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_LT((flown.path[i] - expected[i]).norm(), 0.1) << i << ": " << flown.path[i].transpose();
  }
}

// Metres of the example's places.
constexpr double kSouth = -100.06;
constexpr double kEast = 76.06;

TEST(FlownDji, RisesToTheFirstWaypointGoesThereAndOn) {
  const FlownDji flown = fly(example());
  expect_path(flown, {{0, kSouth, 40}, {0, 0, 40}, {kEast, 0, 45}});
  EXPECT_EQ(flown.hold, (std::vector<double>{0, 1.5, 0}));
  EXPECT_EQ(flown.ends.takeoff_from, 10);
  EXPECT_FALSE(flown.ends.landing_on);
  EXPECT_EQ(flown.speed, 9) << "on the way to the first waypoint";
  EXPECT_TRUE(flown.home_is_said);
  EXPECT_FALSE(flown.lands_below || flown.returns || flown.returns_at);
}

TEST(DjiAircraft, IsAVehicleThatIsKnownByNameIfItsAirframeIs) {
  for (const DjiAirframe& airframe : kDjiAirframes) {
    const auto profile = vehicle_named(airframe.vehicle);
    ASSERT_TRUE(profile) << airframe.vehicle;
    EXPECT_EQ(airframe_of({airframe.type, 9}), &airframe);
    EXPECT_EQ(vehicle_of({airframe.type, 9}), airframe.vehicle) << "of a kind without a name";
    // Or a check would refuse every mission that is faster than the aircraft climbs.
    const double most = *profile->vehicle.limits[geom::Limit::vertical_speed];
    EXPECT_GE(most, std::max(airframe.climb, airframe.descent)) << airframe.vehicle;
  }
  for (const NamedDjiAircraft& known : kDjiAircraft) {
    EXPECT_EQ(vehicle_of(known.aircraft), known.name);
    ASSERT_TRUE(vehicle_named(known.name)) << known.name;
    ASSERT_TRUE(airframe_of(known.aircraft)) << known.name;
    EXPECT_EQ(vehicle_named(known.name)->vehicle.half,
              vehicle_named(airframe_of(known.aircraft)->vehicle)->vehicle.half)
        << known.name;
  }
  EXPECT_EQ(vehicle_of({60, 0}), "");
  EXPECT_FALSE(airframe_of({60, 0}));
}

TEST(FlownDji, ClimbsNoFasterThanTheAircraftCan) {
  DjiMission m = example();
  EXPECT_EQ(fly(m).climb, 6);
  m.aircraft = {99, 1};
  EXPECT_EQ(fly(m).climb, 10);
  EXPECT_EQ(fly(m).descent, 8);
  m.aircraft = {1, 0};
  EXPECT_EQ(fly(m).climb, 0) << "nobody says how fast it is";
}

TEST(FlownDji, CountsFromTheGroundThatIsGivenWhereTheMapsHeightIsNotKnown) {
  const MissionFrame unknown{{47, 8, 0}, 0, false};
  DjiMission m = example();
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
  DjiMission m = example();
  m.security_height = 50;
  expect_path(fly(m), {{0, kSouth, 60}, {0, 0, 60}, {0, 0, 40}, {kEast, 0, 45}});
  m.approach = DjiApproach::point_to_point;
  expect_path(fly(m), {{0, kSouth, 60}, {0, 0, 60}, {0, 0, 40}, {kEast, 0, 45}});
  m.security_height = 5;
  expect_path(fly(m), {{0, kSouth, 15}, {0, 0, 40}, {kEast, 0, 45}});
}

TEST(FlownDji, TakesOffBelowTheFirstWaypointWhereNothingElseIsSaid) {
  DjiMission m = example();
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
  const FlownDji flown = fly(example(), {12, {}});
  EXPECT_EQ(flown.ends.takeoff_from, 12);
  expect_path(flown, {{0, kSouth, 42}, {0, 0, 42}, {kEast, 0, 47}});
}

TEST(FlownDji, HeightsAboveTheEllipsoidDoNotCountFromTheTakeOff) {
  DjiMission m = example();
  m.waylines[0].heights = DjiHeights::ellipsoid;
  m.waylines[0].waypoints[0].height = 440;
  m.waylines[0].waypoints[1].height = 450;
  expect_path(fly(m), {{0, kSouth, 50}, {0, 0, 50}, {kEast, 0, 60}});
}

TEST(FlownDji, GoesOnFromWaylineToWayline) {
  DjiMission m = example();
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
  DjiMission m = example();
  m.finish = DjiFinish::go_home;
  EXPECT_TRUE(fly(m).returns) << "no height";
  m.return_height = 60;
  const FlownDji flown = fly(m);
  EXPECT_FALSE(flown.returns);
  EXPECT_EQ(flown.returns_at, 60);
  EXPECT_FALSE(flown.speed) << "the return's is the aircraft's own";
  EXPECT_EQ(flown.ends.landing_on, 10);
  expect_path(flown,
              {{0, kSouth, 40}, {0, 0, 40}, {kEast, 0, 45}, {kEast, 0, 70}, {0, kSouth, 70}});
  m.return_height = 20;
  expect_path(fly(m), {{0, kSouth, 40}, {0, 0, 40}, {kEast, 0, 45}, {0, kSouth, 45}});
}

TEST(FlownDji, ReturnsAtTheHeightThatIsGivenWhereTheFileSaysNone) {
  DjiMission m = example();
  m.finish = DjiFinish::go_home;
  const FlownDji flown = fly(m, {{}, 60});
  EXPECT_FALSE(flown.returns);
  EXPECT_EQ(flown.returns_at, 60);
  m.return_height = 70;
  EXPECT_EQ(fly(m, {{}, 60}).returns_at, 70);
}

TEST(FlownDji, AReturnFromNearHomeMayRiseOrNot) {
  DjiMission m = example();
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
  DjiMission m = example();
  m.finish = DjiFinish::go_home;
  m.return_height = 60;
  m.takeoff = geom::GeodeticPlace{47, 8.0008, 400};
  EXPECT_TRUE(fly(m).returns);
  m.finish = DjiFinish::first_waypoint;
  EXPECT_TRUE(fly(m).returns) << "nor is that to the first waypoint";
}

TEST(FlownDji, EachLegHasItsWaypoint) {
  DjiMission m = example();
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

// Three waypoints with a right angle at the second, 76 m east and 100 m north.
DjiMission corner(DjiTurn turn, double damping, double height = 30) {
  DjiMission m = example();
  m.waylines[0].waypoints = {
      {47, 8, 30, 4}, {47, 8.001, height, 4}, {47.0009, 8.001, 2 * height - 30, 4}};
  m.waylines[0].waypoints[1].turn = turn;
  m.waylines[0].waypoints[1].damping = damping;
  return m;
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
  expect_hull(fly(corner(DjiTurn::early, 10)),
              {{kEast - 10, 0, 40}, {kEast, 0, 40}, {kEast, 10, 40}});
  EXPECT_TRUE(fly(corner(DjiTurn::stop, 0)).sweeps.empty());
}

TEST(FlownDji, ATurnThroughItsWaypointMaySwingWide) {
  const FlownDji level = fly(corner(DjiTurn::through, 10));
  expect_hull(level, {{kEast - 10, -10, 40},
                      {kEast - 10, -10, 40},
                      {kEast - 10, 10, 40},
                      {kEast - 10, 10, 40},
                      {kEast + 10, -10, 40},
                      {kEast + 10, -10, 40},
                      {kEast + 10, 10, 40},
                      {kEast + 10, 10, 40}});
  const FlownDji rising = fly(corner(DjiTurn::through, 10, 50));
  const auto& hull = rising.sweeps.at(0).hull;
  const double before = 20 * 10 / std::hypot(kEast, 20);
  const double behind = 20 * 10 / std::hypot(kSouth, 20);
  EXPECT_NEAR(hull[0].z(), 60 - before - (before + behind), 0.1);
  EXPECT_NEAR(hull[1].z(), 60 + behind + (before + behind), 0.1);
}

TEST(FlownDji, TurnsMustNotMeet) {
  DjiMission m = corner(DjiTurn::early, 70);
  EXPECT_EQ(support::refusal_of([&] { fly(m); }), "");
  m.waylines[0].waypoints[0].damping = 7;
  m.waylines[0].waypoints[0].turn = DjiTurn::early;
  EXPECT_EQ(support::refusal_of([&] { fly(m); }),
            "m.kmz: expected turns that do not meet, found a leg of 76.06 m, of which turns take "
            "77 m (waypointTurnDampingDist)");
  EXPECT_NE(support::refusal_of([&] { fly(corner(DjiTurn::early, 77)); }), "");
}

TEST(FlownDji, TurnsMustNotMeetBetweenWaylinesEither) {
  DjiMission m = corner(DjiTurn::stop, 0);
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
  DjiMission m = corner(DjiTurn::stop, 0);
  m.waylines[0].waypoints[0].turn = DjiTurn::early;
  m.waylines[0].waypoints[0].damping = 5;
  const FlownDji flown = fly(m);
  ASSERT_EQ(flown.sweeps.size(), 1u);
  EXPECT_LT((flown.sweeps[0].hull[0] - Vec3(0, -5, 40)).norm(), 0.1);
  EXPECT_LT((flown.sweeps[0].hull[2] - Vec3(5, 0, 40)).norm(), 0.1);
}

TEST(FlownDji, LandsOnWhatIsBelow) {
  DjiMission m = example();
  m.finish = DjiFinish::land;
  EXPECT_TRUE(fly(m).lands_below);
}

TEST(FlownDji, AircraftThatDoNotRiseFirstNeedAHighFirstWaypoint) {
  DjiMission m = example();
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
  DjiMission m = example();
  m.waylines[0].waypoints[1].longitude = 151;
  EXPECT_EQ(support::refusal_of([&] { fly(m); }),
            "m.kmz:8: expected a place near the origin 47 8, found 47 151");
  m = example();
  m.takeoff->latitude = -33;
  EXPECT_EQ(support::refusal_of([&] { fly(m); }),
            "m.kmz: expected a place near the origin 47 8, found -33 8");
}

TEST(MakeDjiMission, IsFlownThroughThePoints) {
  DjiOptions options;
  options.home = 2;
  options.speed = 4.5;
  const DjiMission m = make_dji_mission(kPoints, kFrame, options);
  EXPECT_EQ(m.finish, DjiFinish::land);
  const FlownDji flown = flown_dji(m, kFrame, {}, "m");
  ASSERT_EQ(flown.path.size(), kPoints.size());
  for (std::size_t i = 0; i < kPoints.size(); ++i) {
    EXPECT_LT((flown.path[i] - kPoints[i]).norm(), 6e-4) << i;
  }
  EXPECT_NEAR(*flown.ends.takeoff_from, 2, 1e-9);
  EXPECT_EQ(flown.speed, 4.5);
}

TEST(MakeDjiMission, BeginsLowWithARiseToTwoMetres) {
  DjiOptions options;
  options.lands = false;
  const std::vector<Vec3> low = {{0, 0, 1}, {50, 0, 1}};
  const DjiMission m = make_dji_mission(low, kFrame, options);
  EXPECT_EQ(m.security_height, 2);
  EXPECT_EQ(m.finish, DjiFinish::hover);
  EXPECT_EQ(m.transit_speed, 5) << "where none is asked for";
  const FlownDji flown = flown_dji(m, kFrame, {}, "m");
  ASSERT_EQ(flown.path.size(), 3u);
  EXPECT_NEAR(flown.path[0].z(), 2, 1e-9);
  EXPECT_NEAR(flown.path[1].z(), 1, 1e-9);
}

TEST(MakeDjiMission, TurnsWhereItMayAndStopsElsewhere) {
  DjiOptions options;
  options.turns = {10, 10, 10, 0, 10, 10, 10};
  const std::vector<Vec3> points = {{0, 0, 20},  {50, 0, 20},   {50, 8, 20}, {50, 90, 20},
                                    {0, 90, 20}, {0, 90.3, 20}, {0, 99, 20}};
  const auto made = make_dji_mission(points, kFrame, options).waylines[0].waypoints;
  const auto damping = [&](std::size_t i) {
    EXPECT_EQ(made[i].turn, made[i].damping > 0 ? DjiTurn::early : DjiTurn::stop) << i;
    return made[i].damping;
  };
  EXPECT_EQ(damping(0), 0);
  EXPECT_EQ(damping(1), 3.6) << "0.45 of 8 m";
  EXPECT_EQ(damping(2), 3.6);
  EXPECT_EQ(damping(3), 0) << "as asked";
  EXPECT_EQ(damping(4), 0) << "no room";
  EXPECT_EQ(damping(6), 0);
}

TEST(MakeDjiMission, TakesOffWhereTheAircraftStands) {
  DjiOptions options;
  options.takeoff = Vec3(-40, 12, 3);
  options.home = 3;
  const DjiMission m = make_dji_mission(kPoints, kFrame, options);
  EXPECT_EQ(m.without_link, "goBack") << "it returns unless it is told otherwise";
  const FlownDji flown = flown_dji(m, kFrame, {}, "m");
  ASSERT_EQ(flown.path.size(), kPoints.size() + 1);
  EXPECT_LT((flown.path[0] - Vec3(-40, 12, kPoints[0].z())).norm(), 6e-4);
  for (std::size_t i = 0; i < kPoints.size(); ++i) {
    EXPECT_LT((flown.path[i + 1] - kPoints[i]).norm(), 6e-4) << i;
  }
  EXPECT_NEAR(*flown.ends.takeoff_from, 3, 1e-9);
}

TEST(MakeDjiMission, IsNoFasterThanFifteenMetresASecond) {
  DjiOptions options;
  options.speed = 20;
  EXPECT_EQ(make_dji_mission(kPoints, kFrame, options).transit_speed, 15);
}

// Ground that rises by 1 m per 10 m to the east of 0, known within 0.5 m, 400 m around.
geom::GroundModel slope(geom::Axes axes = geom::Axes::enu) {
  std::vector<double> low;
  std::vector<double> high;
  for (int j = 0; j < 80; ++j) {
    for (int i = 0; i < 80; ++i) {
      low.push_back(10 + std::max(0, (axes == geom::Axes::enu ? i : j) - 40));
      high.push_back(low.back() + 1);
    }
  }
  return {{.corner = {-400, -400}, .cell = 10, .columns = 80, .rows = 80, .hash = "sha256:slope"},
          std::move(low),
          std::move(high)};
}

DjiMission along_the_surface() {
  DjiMission m = example();
  m.waylines[0].heights = DjiHeights::above_surface;
  return m;
}

// The heights that a leg of the path may have over a place, by its band.
SurfaceRange held_at(const FlownDji& flown, std::size_t leg) {
  const double band = flown.leg_band[leg - 1];
  return {std::min(flown.path[leg - 1].z(), flown.path[leg].z()) - band,
          std::max(flown.path[leg - 1].z(), flown.path[leg].z()) + band};
}

TEST(FlownDji, FollowsTheSurfaceWithinTheBandThatItsOperatorStates) {
  const geom::GroundModel ground = slope();
  const TerrainRules surface{.ground = &ground, .surface = {{20, 30}}};
  const FlownDji flown = fly(along_the_surface(), {.surface = surface});
  ASSERT_EQ(flown.leg_band.size() + 1, flown.path.size());
  ASSERT_EQ(flown.legs.size(), flown.path.size());
  ASSERT_EQ(flown.hold.size(), flown.path.size());
  EXPECT_EQ(flown.hold[2], 1.5);
  // Up to the security height, above the first waypoint, and into the band: 10 + 20 to 12 + 30.
  ASSERT_GE(flown.path.size(), 3u);
  EXPECT_LT((flown.path[0] - Vec3(0, kSouth, 30)).norm(), 0.1);
  EXPECT_LT((flown.path[1] - Vec3(0, 0, 30)).norm(), 0.1);
  ASSERT_EQ(flown.sweeps.size(), 1u);
  const geom::Aabb face = *geom::bounds(flown.sweeps[0].hull);
  EXPECT_NEAR(face.min.z(), 30, 0.01);
  EXPECT_NEAR(face.max.z(), 41, 0.01);
  EXPECT_NEAR(face.min.y(), kSouth, 0.1);
  for (std::size_t leg = 3; leg < flown.path.size(); ++leg) {
    const double from = std::floor(std::max(0.0, flown.path[leg - 1].x() - 0.1) / 10);
    const double to = std::floor(std::max(0.0, flown.path[leg].x() + 0.1) / 10);
    const SurfaceRange held = held_at(flown, leg);
    EXPECT_LE(held.low, 10 + from + 20) << leg;
    EXPECT_GE(held.high, 10 + to + 1 + 30) << leg;
    EXPECT_GE(held.low, 10 + from + 20 - 3) << leg << ": no wider than it must be";
    EXPECT_LE(held.high, 10 + to + 1 + 30 + 3) << leg;
    EXPECT_LT((flown.path[leg] - flown.path[leg - 1]).head<2>().norm(), 5.01);
  }
  ASSERT_TRUE(flown.terrain);
  EXPECT_EQ(flown.terrain->model, "sha256:slope");
  EXPECT_EQ(flown.terrain->surface, (SurfaceBand{20, 30}));
  EXPECT_TRUE(flown.climb_holds_in_band);
  EXPECT_NEAR(flown.terrain->band, 12, 0.01);
  const double level = 100.06 / 9 + kEast / 4 + 1.5;
  EXPECT_GT(flown.least_seconds, level + (20 + 5 + 7) / 6.0);
  EXPECT_LT(flown.least_seconds, level + (20 + 5 + 15) / 6.0);
}

TEST(FlownDji, FollowsTheSurfaceOfAMapWhoseFirstAxisIsNorth) {
  const geom::GroundModel east = slope();
  const geom::GroundModel swapped = slope(geom::Axes::neu);
  const TerrainRules surface{.ground = &east, .surface = {{20, 30}}};
  const TerrainRules other{.ground = &swapped, .axes = geom::Axes::neu, .surface = {{20, 30}}};
  const FlownDji flown = fly(along_the_surface(), {.surface = surface});
  const FlownDji same = fly(along_the_surface(), {.surface = other});
  EXPECT_EQ(same.path, flown.path);
  EXPECT_EQ(same.leg_band, flown.leg_band);
}

TEST(FlownDji, WhereItMayBeBesideItsWayTheGroundCountsToo) {
  const geom::GroundModel ground = slope();
  const TerrainRules surface{.ground = &ground, .surface = {{20, 30}}};
  const auto band = [&](double around) {
    return fly(along_the_surface(), {.surface = surface, .around = around}).leg_band.back();
  };
  EXPECT_NEAR(band(20) - band(0), 2, 1e-9) << "2 m lower to the west, and 2 m higher to the east";
}

TEST(FlownDji, SurfaceOfWhichTooLittleIsKnownIsRefused) {
  const geom::GroundModel ground = slope();
  const TerrainRules surface{.ground = &ground, .surface = {{20, 30}}};
  const auto refusal = [](const DjiMission& m, const DjiRules& rules) {
    return support::refusal_of([&] { fly(m, rules); });
  };
  DjiMission m = along_the_surface();
  const std::string none =
      "m.kmz:7: expected heights above the ellipsoid or the take-off (executeHeightMode WGS84 or "
      "relativeToStartPoint), found heights above the surface as the aircraft sees it: no file "
      "says how well it keeps them: say between which heights over a height model it stays "
      "(--ground-model, --surface-band)";
  EXPECT_EQ(refusal(m, {}), none);
  EXPECT_EQ(refusal(m, {.surface = TerrainRules{.ground = &ground, .error = 9}}), none);
  EXPECT_EQ(
      refusal(m, {.surface = surface, .around = 330}),
      "m.kmz: expected a height model that knows the ground below the whole way, since the "
      "aircraft follows the surface there, found a hole, or its end, at x -330.011 to 330.011, y "
      "-430.065 to 229.957: take a larger height model (and map)");
  // A model that counts from another zero than the take-off.
  for (const double off : {-5.5, 6.5}) {
    EXPECT_EQ(refusal(m, {.ground = 10 + off, .surface = surface}),
              fmt::format("m.kmz:7: expected a take-off within 5 m of the height model's ground, "
                          "10.0 to 11.0 m there, found one at {:.1f} m: both must count from the "
                          "zero of the map (--ground, --ground-model)",
                          10 + off));
  }
  EXPECT_EQ(refusal(m, {.ground = 5.5, .surface = surface}), "");
  EXPECT_EQ(refusal(m, {.ground = 15.5, .surface = surface}), "");
  m.aircraft = {1, 0};
  EXPECT_EQ(refusal(m, {.surface = surface}),
            "m.kmz:7: expected an aircraft of which is known how fast it climbs, found type 1: it "
            "climbs and sinks as the surface does");
  m = along_the_surface();
  m.waylines.push_back({1, DjiHeights::above_takeoff, {{47, 8, 60, 4, 0, 9}}});
  EXPECT_EQ(refusal(m, {.surface = surface}),
            "m.kmz:7: expected waylines that all follow the surface, or none, found some that do "
            "(executeHeightMode realTimeFollowSurface)");
}

TEST(FlownDji, ReturnsFromAnyHeightOverTheSurface) {
  const geom::GroundModel ground = geom::GroundModel::flat(10);
  const TerrainRules surface{.ground = &ground, .surface = {{20, 40}}};
  DjiMission m = along_the_surface();
  m.finish = DjiFinish::go_home;
  m.return_height = 30;
  const FlownDji flown = fly(m, {.surface = surface});
  EXPECT_EQ(flown.terrain->model, "flat");
  EXPECT_EQ(flown.ends.landing_on, 10);
  EXPECT_NEAR(flown.path.back().z(), 50, 0.01) << "as high as it may begin";
  ASSERT_EQ(flown.sweeps.size(), 2u);
  EXPECT_EQ(flown.sweeps[1].part, (FlightPart{1, Manoeuvre::return_home}));
  const auto& hull = flown.sweeps[1].hull;
  EXPECT_NEAR(hull[0].z(), 30, 0.01);
  EXPECT_NEAR(hull[1].z(), 50, 0.01);
  EXPECT_NEAR(hull[2].z(), 40, 0.01) << "over home it has risen to the return's height";
  EXPECT_NEAR(hull[3].z(), 50, 0.01);
  m.takeoff = geom::GeodeticPlace{47, 8.0005, 400};
  EXPECT_NEAR(fly(m, {.surface = surface}).sweeps[1].hull[2].z(), 30, 0.01)
      << "near home it may not rise";
}

TEST(FlownDji, TurnsOverTheSurfaceAreAsHighAsItMayBe) {
  const geom::GroundModel ground = geom::GroundModel::flat(10);
  const TerrainRules surface{.ground = &ground, .surface = {{20, 40}}};
  DjiMission m = corner(DjiTurn::early, 10);
  m.waylines[0].heights = DjiHeights::above_surface;
  const FlownDji flown = fly(m, {.surface = surface});
  ASSERT_EQ(flown.sweeps.size(), 2u);
  EXPECT_EQ(flown.sweeps[1].part, (FlightPart{1, Manoeuvre::corner}));
  const geom::Aabb turn = *geom::bounds(flown.sweeps[1].hull);
  EXPECT_LT((turn.min - Vec3(kEast - 10, 0, 30)).norm(), 0.1);
  EXPECT_LT((turn.max - Vec3(kEast, 10, 50)).norm(), 0.1);
  // How steep the legs are is not known, so it may turn as far out as over flat ground.
  const geom::GroundModel hill = slope();
  const TerrainRules rising{.ground = &hill, .surface = {{20, 40}}};
  const geom::Aabb risen = *geom::bounds(fly(m, {.surface = rising}).sweeps[1].hull);
  EXPECT_NEAR(risen.min.x(), turn.min.x(), 1e-9);
  EXPECT_NEAR(risen.max.y(), turn.max.y(), 1e-9);
  m.waylines[0].waypoints[1].damping = 77;
  EXPECT_EQ(support::refusal_of([&] { fly(m, {.surface = surface}); }),
            "m.kmz: expected turns that do not meet, found a leg of 76.06 m, of which turns take "
            "77 m (waypointTurnDampingDist)");
}

}  // namespace
}  // namespace traj
