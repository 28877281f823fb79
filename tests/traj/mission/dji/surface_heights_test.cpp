#include "mission/dji/surface_heights.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/reading.h"
#include "traj/mission/dji/dji_flight_examples.h"

namespace traj {
namespace {

using testing::dji_corner;
using testing::dji_example;
using testing::fly;
using testing::kEast;
using testing::kSouth;

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
  DjiMission m = dji_example();
  m.waylines[0].heights = DjiHeights::above_surface;
  return m;
}

// The heights that a leg of the path may have over a place, by its band.
SurfaceRange held_at(const FlownDji& flown, std::size_t leg) {
  const double band = flown.leg_band[leg - 1];
  return {std::min(flown.path[leg - 1].z(), flown.path[leg].z()) - band,
          std::max(flown.path[leg - 1].z(), flown.path[leg].z()) + band};
}

TEST(SurfaceHeights, FollowsTheSurfaceWithinTheBandThatItsOperatorStates) {
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

TEST(SurfaceHeights, FollowsTheSurfaceOfAMapWhoseFirstAxisIsNorth) {
  const geom::GroundModel east = slope();
  const geom::GroundModel swapped = slope(geom::Axes::neu);
  const TerrainRules surface{.ground = &east, .surface = {{20, 30}}};
  const TerrainRules other{.ground = &swapped, .axes = geom::Axes::neu, .surface = {{20, 30}}};
  const FlownDji flown = fly(along_the_surface(), {.surface = surface});
  const FlownDji same = fly(along_the_surface(), {.surface = other});
  EXPECT_EQ(same.path, flown.path);
  EXPECT_EQ(same.leg_band, flown.leg_band);
}

TEST(SurfaceHeights, WhereItMayBeBesideItsWayTheGroundCountsToo) {
  const geom::GroundModel ground = slope();
  const TerrainRules surface{.ground = &ground, .surface = {{20, 30}}};
  const auto band = [&](double around) {
    return fly(along_the_surface(), {.surface = surface, .around = around}).leg_band.back();
  };
  EXPECT_NEAR(band(20) - band(0), 2, 1e-9) << "2 m lower to the west, and 2 m higher to the east";
}

TEST(SurfaceHeights, SurfaceOfWhichTooLittleIsKnownIsRefused) {
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

TEST(SurfaceHeights, ReturnsFromAnyHeightOverTheSurface) {
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

TEST(SurfaceHeights, TurnsOverTheSurfaceAreAsHighAsItMayBe) {
  const geom::GroundModel ground = geom::GroundModel::flat(10);
  const TerrainRules surface{.ground = &ground, .surface = {{20, 40}}};
  DjiMission m = dji_corner(DjiTurn::early, 10);
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
