#include "traj/submit/risk_volumes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "geom/base/error.h"
#include "geom/map/geographic_frame.h"
#include "geom/map/ground_model.h"
#include "traj/mission/airspace/volume_around.h"
#include "traj/submit/risk_geojson.h"

namespace {

using geom::Vec2;

const geom::GeodeticOrigin kOrigin{47.4, 8.5, 400};

geom::Volume4d zone(const std::vector<Vec2>& plan, double low, double high) {
  geom::Volume4d out = traj::volume_around({plan, low, high}, kOrigin, "test");
  out.start = "2026-05-04T06:30:00Z";
  out.end = "2026-05-04T06:40:00Z";
  return out;
}

traj::RiskTask task() {
  traj::RiskTask out{.speed = 10, .floor = 0, .origin = kOrigin};
  out.rules.dimension = 0.7;
  return out;
}

geom::IntentVolumes intent() {
  return {
      {zone({{0, 0}, {300, 20}, {280, 90}}, 20, 60), zone({{280, 0}, {600, 0}, {500, 40}}, 10, 30)},
      {}};
}

std::vector<Vec2> ring_of(const geom::Volume4d& volume) {
  const geom::GeographicFrame earth(kOrigin);
  std::vector<Vec2> out;
  for (const auto& p : volume.outline.ring) out.push_back(earth.enu(p).head<2>());
  return out;
}

// By the signs of the ring's turns around the point; the ring is convex and counterclockwise.
bool inside(const std::vector<Vec2>& ring, const Vec2& p) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 along = ring[(i + 1) % ring.size()] - ring[i];
    if (along.x() * (p - ring[i]).y() - along.y() * (p - ring[i]).x() < 0) return false;
  }
  return true;
}

TEST(RiskVolumes, HoldEveryPlaceThatIsAsFarAsTheFormulasSay) {
  const geom::IntentVolumes around = intent();
  const traj::RiskVolumes risk = traj::risk_volumes(around, task(), "test");
  const traj::ContingencySize size = traj::contingency_size(task().rules, 10);
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> turn(0, 2 * M_PI);
  ASSERT_EQ(risk.buffers.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const auto contingency = ring_of(risk.contingency[i]);
    const auto buffer = ring_of(risk.buffers[i].volume);
    EXPECT_LE(*risk.contingency[i].lower, *around.nominal[i].lower - size.vertical);
    EXPECT_GE(*risk.contingency[i].upper, *around.nominal[i].upper + size.vertical);
    EXPECT_GE(risk.buffers[i].height, *risk.contingency[i].upper - 400);
    EXPECT_EQ(risk.buffers[i].across, risk.buffers[i].height + 0.35);
    for (int k = 0; k < 2000; ++k) {
      const double angle = turn(random);
      const Vec2 out(std::cos(angle), std::sin(angle));
      for (const Vec2& p : ring_of(around.nominal[i])) {
        EXPECT_TRUE(inside(contingency, p + size.across * out));
      }
      for (const Vec2& p : contingency) {
        EXPECT_TRUE(inside(buffer, p + risk.buffers[i].across * out));
      }
    }
  }
}

TEST(RiskVolumes, AreProvedAsTheyAreReadBack) {
  const geom::IntentVolumes around = intent();
  const traj::RiskVolumes risk = traj::risk_volumes(around, task(), "test");
  const traj::ReadRisk read =
      traj::read_risk_geojson(traj::risk_geojson("q1", around, risk), "risk.geojson");
  EXPECT_EQ(read.id, "q1");
  EXPECT_EQ(read.geography.size(), 2u);
  EXPECT_EQ(traj::why_risk_not_held(around, read.volumes, task(), "test"), std::nullopt);
}

TEST(RiskVolumes, AreRefusedWhereTheyAreTooSmallOrTooShort) {
  const geom::IntentVolumes around = intent();
  const traj::RiskVolumes good = traj::risk_volumes(around, task(), "test");
  const auto refused = [&](auto change) {
    traj::RiskVolumes bad = good;
    change(bad);
    try {
      return traj::why_risk_not_held(around, bad, task(), "test").has_value();
    } catch (const geom::InputError&) {
      return true;  // no volume at all: its edges cross
    }
  };
  EXPECT_TRUE(refused([](auto& bad) { *bad.contingency[0].upper -= 1; }));
  EXPECT_TRUE(refused([](auto& bad) { *bad.contingency[1].lower += 1; }));
  EXPECT_TRUE(refused([](auto& bad) { bad.contingency[0].start = "2026-05-04T06:30:01Z"; }));
  EXPECT_TRUE(refused([](auto& bad) { bad.buffers[0].volume.end = "2026-05-04T06:39:59Z"; }));
  EXPECT_TRUE(refused([](auto& bad) { bad.buffers[0].across -= 0.1; }));
  EXPECT_TRUE(refused([](auto& bad) { bad.buffers.pop_back(); }));
  EXPECT_TRUE(refused([](auto& bad) { std::swap(bad.buffers[0].volume, bad.buffers[1].volume); }));
  for (std::size_t i = 0; i < good.buffers[0].volume.outline.ring.size(); ++i) {
    EXPECT_TRUE(refused([i](auto& bad) {  // a corner that is drawn in
      auto& ring = bad.buffers[0].volume.outline.ring;
      double latitude = 0;
      double longitude = 0;
      for (const auto& p : ring) latitude += p.latitude, longitude += p.longitude;
      const double count = static_cast<double>(ring.size());
      ring[i].latitude += 0.1 * (latitude / count - ring[i].latitude);
      ring[i].longitude += 0.1 * (longitude / count - ring[i].longitude);
    })) << i;
  }
  traj::RiskTask faster = task();
  faster.speed = 10.2;
  EXPECT_TRUE(traj::why_risk_not_held(around, good, faster, "test").has_value());
  EXPECT_FALSE(refused([](auto&) {}));
}

// A valley of 10 m depth, where x (in the map's axes) is from 1000 to 1100 m.
geom::GroundModel valley() {
  geom::GroundGridSpec spec;
  spec.corner = {-2000, -2000};
  spec.cell = 100;
  spec.columns = spec.rows = 40;
  std::vector<double> heights(1600, 0.0);
  for (std::size_t row = 0; row < 40; ++row) heights[row * 40 + 30] = -10;
  return {spec, heights, heights};
}

TEST(RiskVolumes, AreRefusedWhereTheGroundIsLowerThanTheFloor) {
  const geom::GroundModel ground = valley();
  const geom::IntentVolumes beside = intent();
  const geom::IntentVolumes over{{zone({{950, 0}, {1050, 0}, {1000, 60}}, 20, 60)}, {}};
  const auto why = [&](const geom::IntentVolumes& around, double floor, geom::Axes axes) {
    traj::RiskTask asked = task();
    asked.floor = floor;
    asked.ground = traj::TerrainRules{&ground, axes, 0};
    return traj::why_risk_not_held(around, traj::risk_volumes(around, asked, "test"), asked,
                                   "test");
  };
  EXPECT_EQ(why(over, 0, geom::Axes::enu),
            "the ground below is as low as z -10.0 by the height model, and heights of ground risk "
            "buffers count from z 0: give --ground-level -10.0");
  EXPECT_EQ(why(over, -10, geom::Axes::enu), std::nullopt);
  EXPECT_TRUE(why(over, -9.99, geom::Axes::enu));
  EXPECT_EQ(why(beside, 0, geom::Axes::enu), std::nullopt);
  EXPECT_EQ(why(over, 0, geom::Axes::neu), std::nullopt) << "the valley is north of it then";
}

TEST(RiskVolumes, OfWaysHomeAreTheVolumesThemselves) {
  traj::RiskTask home = task();
  home.rules.contingency = traj::ContingencyRule::ways_home;
  geom::IntentVolumes both = intent();
  both.off_nominal.push_back(zone({{0, 0}, {900, 0}, {900, 300}}, 0, 80));
  const traj::RiskVolumes risk = traj::risk_volumes(both, home, "test");
  EXPECT_EQ(risk.contingency.size(), 3u);
  EXPECT_EQ(traj::why_risk_not_held(both, risk, home, "test"), std::nullopt);
  EXPECT_TRUE(traj::why_risk_not_held(intent(), risk, home, "test").has_value());
}

}  // namespace
