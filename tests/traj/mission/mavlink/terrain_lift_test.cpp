#include "mission/mavlink/terrain_lift.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "geom/shape/hull.h"
#include "support/reading.h"

namespace traj {
namespace {

const MissionFrame kFrame{{47, 8, 400}, 0};
constexpr double kHome = 12;  // z

// A mission about (47, 8): places in metres from there, heights above terrain.
Mission mission_over(const std::vector<Vec3>& points) {
  const geom::GeographicFrame earth(kFrame.origin);
  Mission mission;
  mission.home = geom::GeodeticPlace{47, 8, 400 + kHome};
  mission.home->latitude = earth.place(points.front()).latitude;
  mission.home->longitude = earth.place(points.front()).longitude;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const geom::GeodeticPlace place = earth.place(points[i]);
    MissionItem item;
    item.command = i == 0 ? kTakeoff : kWaypoint;
    item.frame = i == 0 ? kGlobalRelative : kGlobalTerrain;
    item.latitude = place.latitude;
    item.longitude = place.longitude;
    item.altitude = points[i].z();
    item.number = i + 1;
    mission.items.push_back(item);
  }
  return mission;
}

// Rolling ground over 2 km square about the origin, and a model that bounds it.
struct Hills {
  explicit Hills(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> any(0, 1);
    for (auto& wave : waves) {
      wave = {any(random) * 0.02, any(random) * 0.02, any(random) * 6, 3 + 9 * any(random)};
    }
  }

  double at(double x, double y) const {
    double z = kHome;
    for (const auto& [a, b, phase, high] : waves) z += high * std::sin(a * x + b * y + phase);
    return z;
  }

  geom::GroundModel model(double hole_from = 1e9) const {
    constexpr double kCell = 20;
    constexpr std::size_t kCells = 100;
    std::vector<double> low;
    std::vector<double> high;
    for (std::size_t j = 0; j < kCells; ++j) {
      for (std::size_t i = 0; i < kCells; ++i) {
        double least = 1e9;
        double most = -1e9;
        const double x0 = -1000 + kCell * static_cast<double>(i);
        const double y0 = -1000 + kCell * static_cast<double>(j);
        for (double x = x0; x <= x0 + kCell; x += 2) {
          for (double y = y0; y <= y0 + kCell; y += 2) {
            least = std::min(least, at(x, y));
            most = std::max(most, at(x, y));
          }
        }
        const bool hole = x0 >= hole_from;
        low.push_back(hole ? NAN : least - 0.5);
        high.push_back(hole ? NAN : most + 0.5);
      }
    }
    geom::GroundGridSpec spec;
    spec.corner = {-1000, -1000};
    spec.cell = kCell;
    spec.columns = spec.rows = kCells;
    spec.hash = "sha256:hills";
    return {spec, low, high};
  }

  std::array<std::array<double, 4>, 4> waves{};
};

// What an autopilot has of it: whole metres at posts, off by up to `error`, and straight between.
struct Posts {
  const Hills& hills;
  double spacing = 100;
  double error = 0;
  double shift = 0;
  std::uint64_t seed = 0;

  double post(long i, long j) const {
    std::mt19937_64 random(seed * 1000003 + static_cast<std::uint64_t>((i + 500) * 1000 + j + 500));
    std::uniform_real_distribution<double> off(-error, error);
    const double x = shift + spacing * static_cast<double>(i);
    const double y = shift + spacing * static_cast<double>(j);
    return std::trunc(hills.at(x, y) + off(random));
  }

  double at(double x, double y) const {
    const double u = (x - shift) / spacing;
    const double v = (y - shift) / spacing;
    const auto i = static_cast<long>(std::floor(u));
    const auto j = static_cast<long>(std::floor(v));
    const double a = u - std::floor(u);
    const double b = v - std::floor(v);
    return (1 - a) * (1 - b) * post(i, j) + a * (1 - b) * post(i + 1, j) +
           (1 - a) * b * post(i, j + 1) + a * b * post(i + 1, j + 1);
  }
};

FlownMavlink fly(const Mission& mission, const geom::GroundModel& ground, double error,
                 const MissionRules& base = {}) {
  MissionRules rules = base;
  rules.terrain = TerrainRules{&ground, geom::Axes::enu, error};
  return flown_mission(mission, kFrame, rules, "m");
}

const std::vector<Vec3> kLoop{{0, 0, 40}, {300, 100, 40}, {420, -250, 60}, {-150, -300, 45}};

// How far the place is beyond the band of the leg, <= 0: within.
double beyond(const FlownMavlink& flown, const Vec3& p) {
  double least = 1e9;
  for (std::size_t i = 1; i < flown.path.size(); ++i) {
    const Vec3& a = flown.path[i - 1];
    const Vec3 way = flown.path[i] - a;
    const double length = way.head<2>().squaredNorm();
    if (length == 0) continue;
    const double share = (p - a).head<2>().dot(way.head<2>()) / length;
    if (share < -1e-4 || share > 1 + 1e-4 || (a + share * way - p).head<2>().norm() > 1e-3)
      continue;
    least = std::min(least, std::abs(a.z() + share * way.z() - p.z()) - flown.leg_band[i - 1]);
  }
  return least;
}

bool in_drift(const FlownMavlink& flown, const Vec3& p) {
  const Vec3 hair = Vec3::Constant(1e-3);
  for (const Sweep& sweep : flown.drift.front().sweeps) {
    if (geom::hull_meets(sweep.hull, {p - hair, p + hair})) return true;
  }
  return false;
}

TEST(RaisedOverTerrain, HoldsWhatAnyTerrainWithinTheErrorMakesOfIt) {
  for (const std::uint64_t seed : {1, 2, 3, 4, 5, 6}) {
    const Hills hills(seed);
    const geom::GroundModel model = hills.model();
    const double error = static_cast<double>(seed % 3) * 4;
    const FlownMavlink flown = fly(mission_over(kLoop), model, error);
    ASSERT_TRUE(flown.terrain);
    for (const double shift : {0.0, 31.0, 77.0}) {
      const Posts posts{hills, 100, error, shift, seed};
      for (std::size_t leg = 1; leg < kLoop.size(); ++leg) {
        for (double share = 0; share <= 1; share += 0.01) {
          Vec3 p = kLoop[leg - 1] + share * (kLoop[leg] - kLoop[leg - 1]);
          p.z() += kHome + posts.at(p.x(), p.y()) - posts.at(0, 0);
          EXPECT_LE(beyond(flown, p), 0) << "seed " << seed << ", leg " << leg << ", " << share;
          EXPECT_TRUE(in_drift(flown, p)) << "seed " << seed << ", leg " << leg << ", " << share;
        }
      }
    }
  }
}

// The vehicle follows its terrain no faster than it climbs and sinks, and slows down where it is
// too far behind.
TEST(RaisedOverTerrain, HoldsAVehicleThatIsBehindItsTerrain) {
  for (const std::uint64_t seed : {11, 12, 13, 14}) {
    const Hills hills(seed);
    const geom::GroundModel model = hills.model();
    const FlownMavlink flown = fly(mission_over(kLoop), model, 0);
    const Posts posts{hills, 100, 0, 13, seed};
    constexpr double kStep = 0.05;  // s
    double raise = 0;
    double speed = 0;
    for (std::size_t leg = 1; leg < kLoop.size(); ++leg) {
      const Vec3 way = kLoop[leg] - kLoop[leg - 1];
      const double length = way.norm();
      for (double at = 0; at < length;) {
        Vec3 p = kLoop[leg - 1] + way * (at / length);
        const double wanted = posts.at(p.x(), p.y()) - posts.at(0, 0);
        raise += std::clamp(wanted - raise, -1.5 * kStep, 2.5 * kStep);
        const double behind = std::abs(wanted - raise);
        const double most = 10 * std::clamp(2 - behind / 5, 0.01, 1.0);
        speed += std::clamp(most - speed, -2.5 * kStep, 2.5 * kStep);
        p.z() += kHome + raise;
        ASSERT_LE(beyond(flown, p), 0) << "seed " << seed << ", leg " << leg << ", " << at;
        at += speed * kStep + 1e-6;
      }
    }
  }
}

TEST(RaisedOverTerrain, OverHomeItIsAsHighAsItSays) {
  const Hills hills(7);
  const geom::GroundModel model = hills.model();
  const FlownMavlink flown = fly(mission_over(kLoop), model, 16);
  EXPECT_NEAR(flown.path.front().z(), kHome + 40, 1e-9);
  EXPECT_NEAR(*flown.ends.takeoff_from, kHome, 1e-9);
  EXPECT_GT(flown.leg_band.front(), 1);
}

TEST(RaisedOverTerrain, MoreErrorIsAWiderBand) {
  const Hills hills(7);
  const geom::GroundModel model = hills.model();
  const double exact = fly(mission_over(kLoop), model, 0).terrain->band;
  const double rough = fly(mission_over(kLoop), model, 10).terrain->band;
  EXPECT_NEAR(rough, exact + 40, 1) << "at home and below, up and down";
}

TEST(RaisedOverTerrain, FlatGroundLeavesWhatWholeMetresLeaveOpen) {
  const geom::GroundModel flat = geom::GroundModel::flat(-300);
  const FlownMavlink flown = fly(mission_over(kLoop), flat, 0);
  EXPECT_NEAR(flown.terrain->band, 5, 1e-9)
      << "a metre at home, and below, and half a metre that it does not say";
  EXPECT_NEAR(flown.path[1].z(), kHome + 40, 3) << "home's height counts, not the model's zero";
}

TEST(RaisedOverTerrain, TakesAsLongAgainAsItRisesWithTheGround) {
  const geom::GroundModel flat = geom::GroundModel::flat(-300);
  const Hills hills(7);
  const geom::GroundModel model = hills.model();
  const double level = fly(mission_over(kLoop), flat, 0).least_seconds;
  double way = 0;
  double rise = 0;
  for (std::size_t leg = 1; leg < kLoop.size(); ++leg) {
    const Vec3 by = kLoop[leg] - kLoop[leg - 1];
    way += by.head<2>().norm();
    for (int k = 0; k < 40; ++k) {
      const Vec3 p = kLoop[leg - 1] + k / 40.0 * by;
      const Vec3 q = p + by / 40;
      rise += std::abs(hills.at(q.x(), q.y()) - hills.at(p.x(), p.y()));
    }
  }
  EXPECT_GT(level, 40 / 2.5 + way / 10);
  EXPECT_NEAR(fly(mission_over(kLoop), model, 0).least_seconds, level + rise / 1.5, 0.15 * rise);
}

TEST(RaisedOverTerrain, LandsOnTheGroundBelow) {
  const Hills hills(8);
  const geom::GroundModel model = hills.model();
  Mission mission = mission_over({{0, 0, 40}, {300, 100, 40}, {300, 100, 0}});
  mission.items.back().command = kLand;
  const FlownMavlink away = fly(mission, model, 2);
  const geom::GroundRange ground = model.range({{300, 100}, {300, 100}});
  EXPECT_GE(*away.ends.landing_on, ground.low);
  EXPECT_LE(*away.ends.landing_on, ground.high);
  EXPECT_TRUE(in_drift(away, {300, 100, *away.ends.landing_on + 0.1}));
  mission = mission_over({{0, 0, 40}, {300, 100, 40}, {0, 0, 0}});
  mission.items.back().command = kLand;
  const FlownMavlink home = fly(mission, model, 2);
  EXPECT_NEAR(*home.ends.landing_on, kHome, 1e-9);
  EXPECT_TRUE(in_drift(home, {0, 0, kHome + 0.1}));
}

TEST(RaisedOverTerrain, IsArdupilotsAlone) {
  const geom::GroundModel flat = geom::GroundModel::flat(0);
  const FlownMavlink flown = fly(mission_over(kLoop), flat, 0);
  EXPECT_TRUE(flown.above_terrain);
  ASSERT_EQ(flown.drift.size(), 1u);
  EXPECT_TRUE(flown.drift.front().autopilot.starts_with("ardupilot"));
  EXPECT_EQ(
      support::refusal_of([&] { fly(mission_over(kLoop), flat, 0, {.autopilots = {px4()}}); }),
      "m: item 2: expected what PX4 flies, found a height above terrain: PX4 loads no mission "
      "with it, and no other autopilot is asked for (--autopilot)");
  Autopilot with_rangefinder = ardupilot();
  with_rangefinder.follows_terrain = false;
  EXPECT_NE(support::refusal_of(
                [&] { fly(mission_over(kLoop), flat, 0, {.autopilots = {with_rangefinder}}); }),
            "");
}

// The last waypoint is a rest, and a return follows.
Mission returning() {
  Mission mission = mission_over(kLoop);
  mission.items.back().param[0] = 5;
  mission.items.push_back({.frame = kMissionFrame, .command = kReturn, .number = 9});
  return mission;
}

TEST(RaisedOverTerrain, ReturnsAboveAllHeightsAtWhichItMayBegin) {
  const Hills hills(15);
  const geom::GroundModel model = hills.model();
  const FlownMavlink flown = fly(returning(), model, 3, {.return_height = 160});
  EXPECT_FALSE(flown.returns);
  const double top = kHome + 160;
  EXPECT_NEAR(flown.path.back().z(), top, 1e-9);
  EXPECT_NEAR(*flown.ends.landing_on, kHome, 1e-9);
  EXPECT_EQ(flown.leg_band.back(), 0);
  const Vec3 end = kLoop.back();
  for (const double shift : {0.0, 50.0}) {
    const Posts posts{hills, 100, 3, shift, 15};
    const double begins = kHome + end.z() + posts.at(end.x(), end.y()) - posts.at(0, 0);
    for (double z = begins; z <= top; z += 4) EXPECT_TRUE(in_drift(flown, {end.x(), end.y(), z}));
  }
  for (double share = 0; share <= 1; share += 0.05) {
    EXPECT_TRUE(in_drift(flown, {(1 - share) * end.x(), (1 - share) * end.y(), top}));
  }
  for (double z = kHome + 1; z <= top; z += 5) EXPECT_TRUE(in_drift(flown, {0, 0, z}));
}

TEST(RaisedOverTerrain, ItsReturnIsNotKnownWhereThatMayBeginHigher) {
  const geom::GroundModel flat = geom::GroundModel::flat(0);
  EXPECT_FALSE(fly(returning(), flat, 0, {.return_height = 48}).returns)
      << "45 m, and 2.5 m of posts";
  EXPECT_TRUE(fly(returning(), flat, 0, {.return_height = 46}).returns);
  EXPECT_TRUE(fly(returning(), flat, 3, {.return_height = 48}).returns);
  EXPECT_TRUE(fly(returning(), flat, 0).returns) << "nobody says the height";
  Mission passed = returning();
  passed.items[passed.items.size() - 2].param[0] = 0;
  EXPECT_TRUE(fly(passed, flat, 0, {.return_height = 90}).returns) << "it may begin anywhere";
  Mission rally = returning();
  rally.rally = {{47.0001, 8, 20}};
  EXPECT_TRUE(fly(rally, flat, 0, {.return_height = 90}).returns);
}

TEST(RaisedOverTerrain, RefusesHolesAndTheEndOfTheModel) {
  const Hills hills(9);
  const geom::GroundModel model = hills.model(500);
  EXPECT_TRUE(support::refusal_of([&] {
                fly(mission_over(kLoop), model, 0);
              }).starts_with("m: expected a height model that knows the ground within "));
  const geom::GroundModel whole = hills.model();
  EXPECT_EQ(support::refusal_of([&] { fly(mission_over(kLoop), whole, 0); }), "");
  EXPECT_NE(support::refusal_of([&] {
              fly(mission_over({{0, 0, 40}, {900, 0, 40}}), whole, 0);
            }),
            "")
      << "the autopilot's posts may lie beyond";
}

TEST(CountsFromTerrain, RefusesWhatCountsFromElsewhereOnTheWay) {
  const geom::GroundModel flat = geom::GroundModel::flat(0);
  const auto refusal = [&](const auto& change) {
    Mission mission = mission_over(kLoop);
    change(mission);
    return support::refusal_of([&] { fly(mission, flat, 0); });
  };
  EXPECT_EQ(refusal([](Mission& m) { m.items[2].frame = kGlobalRelative; }),
            "m: item 3: expected a height above terrain, as another waypoint of the mission has, "
            "found frame 3: how high the way between them is depends on where the autopilot looks "
            "at its terrain");
  EXPECT_EQ(refusal([](Mission& m) { m.items[2].altitude = 0; }),
            "m: item 3: expected a height above terrain, found 0");
  EXPECT_EQ(refusal([](Mission& m) { m.items[2].command = kLoiterToHeight; }),
            "m: item 3: expected no climb (31) and no payload's place (94) in a mission above "
            "terrain, found command 31: these count from home");
  EXPECT_EQ(
      refusal([](Mission& m) {
        m.items.erase(m.items.begin());
        m.home.reset();
      }),
      "m: expected home or a take-off as its first item, since the autopilot's terrain counts "
      "from home, found neither");
}

// To a landing that counts from home it would fly at one height, whatever the terrain.
TEST(CountsFromTerrain, TakesLandingsElsewhereAboveTerrainAlone) {
  const geom::GroundModel flat = geom::GroundModel::flat(0);
  Mission mission = mission_over({{0, 0, 40}, {300, 100, 40}, {300, -200, 0}});
  mission.items.back().command = kLand;
  EXPECT_EQ(support::refusal_of([&] { fly(mission, flat, 0); }), "");
  mission.items.back().frame = kGlobalRelative;
  EXPECT_EQ(support::refusal_of([&] { fly(mission, flat, 0); }),
            "m: item 3: expected a landing's place with a height above terrain (frame 10), found "
            "frame 3: an autopilot flies there at one height above home, whatever the terrain");
  mission.items.back().latitude = mission.items.back().longitude = 0;
  EXPECT_EQ(support::refusal_of([&] { fly(mission, flat, 0); }), "") << "it lands where it is";
}

// To a landing it flies as high as it was when it took the last waypoint for reached.
TEST(RaisedOverTerrain, ALandingElsewhereIsWiderByTheRadiusOfAWaypoint) {
  const geom::GroundModel flat = geom::GroundModel::flat(0);
  Mission mission = mission_over({{0, 0, 40}, {300, 100, 40}, {300, -200, 40}});
  const double band = fly(mission, flat, 0).terrain->band;
  mission.items.back().command = kLand;
  mission.items.back().altitude = 0;
  EXPECT_NEAR(fly(mission, flat, 0).terrain->band, band + 2 * 2, 1e-9) << "WPNAV_RADIUS is 2 m";
}

// On a circle it does not slow down for its terrain.
TEST(RaisedOverTerrain, AMissionWithACircleMayBeBehindByAllOfItsTerrain) {
  const Hills hills(3);
  const geom::GroundModel model = hills.model();
  Mission mission = mission_over({{0, 0, 40}, {300, 100, 40}, {420, -250, 40}});
  mission.items[1].param[0] = 2;
  const FlownMavlink straight = fly(mission, model, 0);
  EXPECT_EQ(straight.terrain->lag, 10);
  mission.items.back().command = kLoiterTurns;
  mission.items.back().param[0] = 1;
  mission.items.back().param[2] = 60;
  const FlownMavlink round = fly(mission, model, 0);
  EXPECT_GT(round.terrain->lag, 10);
  EXPECT_NEAR(round.terrain->lag, round.terrain->band, 1e-9);
}

// A post's height is of a place that may lie further away, the more so the further from the
// equator.
TEST(RaisedOverTerrain, PostsAreFurtherAwayWhereDegreesAreNarrower) {
  const Hills hills(4);
  const geom::GroundModel model = hills.model();
  const auto band_at = [&](double latitude) {
    const MissionFrame frame{{latitude, 8, 400}, 0};
    Mission mission = mission_over(kLoop);
    const geom::GeographicFrame to(frame.origin);
    for (std::size_t i = 0; i < kLoop.size(); ++i) {
      const geom::GeodeticPlace place = to.place(kLoop[i]);
      mission.items[i].latitude = place.latitude;
      mission.items[i].longitude = place.longitude;
    }
    mission.home->latitude = mission.items.front().latitude;
    mission.home->longitude = mission.items.front().longitude;
    MissionRules rules;
    rules.terrain = TerrainRules{&model, geom::Axes::enu, 0};
    return flown_mission(mission, frame, rules, "m").terrain->band;
  };
  EXPECT_LT(band_at(0.5), band_at(47));
  EXPECT_LT(band_at(-47), band_at(65));
  EXPECT_NE(support::refusal_of([&] { band_at(-84.5); }), "") << "near a pole there is no bound";
}

TEST(CountsFromTerrain, IsFalseWithoutSuchHeights) {
  const geom::GroundModel flat = geom::GroundModel::flat(0);
  Mission mission = mission_over(kLoop);
  for (MissionItem& item : mission.items) item.frame = kGlobalRelative;
  const FlownMavlink flown = fly(mission, flat, 9);
  EXPECT_FALSE(flown.terrain);
  EXPECT_EQ(flown.path.size(), kLoop.size());
}

}  // namespace
}  // namespace traj
