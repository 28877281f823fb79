#include "geom/zone/zone_boxes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geom/base/error.h"
#include "geom/base/random.h"
#include "geom/map/geographic_frame.h"
#include "support/random_city.h"

namespace geom {
namespace {

BoxMapSpec spec_at(double latitude, double longitude) {
  return {.frame = {.origin = GeodeticOrigin{latitude, longitude, 0}},
          .bounds = {{-1000, -1000, 0}, {1000, 1000, 500}}};
}

ZoneFile circle(double latitude, double longitude, double radius) {
  ZoneFile file;
  Zone& zone = file.zones.emplace_back();
  zone.identifier = "C";
  zone.volumes.emplace_back().outline.centre = {latitude, longitude, 0};
  zone.volumes[0].outline.radius = radius;
  return file;
}

ZoneFile polygon(const BoxMapSpec& spec, const std::vector<Vec2>& ring) {
  const GeographicFrame earth(*spec.frame.origin);
  ZoneFile file;
  Zone& zone = file.zones.emplace_back();
  zone.identifier = "P";
  ZoneVolume& volume = zone.volumes.emplace_back();
  for (const Vec2& p : ring) {
    GeodeticPlace& place = volume.outline.ring.emplace_back();
    earth.to_geodetic(p.x(), p.y(), place.latitude, place.longitude);
  }
  return file;
}

bool closed(const ZoneBoxes& boxes, const Vec3& p) {
  return std::any_of(boxes.table.boxes.begin(), boxes.table.boxes.end(),
                     [&](const Aabb& box) { return contains(box, p); });
}

TEST(ZoneBoxes, HoldACircleAndNoMoreThanTheSlackAround) {
  const BoxMapSpec spec = spec_at(47, 8);
  const ZoneBoxes boxes = zone_boxes(circle(47, 8, 400), "z", {.spec = spec, .slack = 3});
  support::Random random(3);
  for (int i = 0; i < 5000; ++i) {
    const double angle = random.uniform(0, 2 * M_PI);
    const Vec2 way(std::cos(angle), std::sin(angle));
    const Vec2 in = way * random.uniform(0, 400);
    ASSERT_TRUE(closed(boxes, {in.x(), in.y(), random.uniform(0, 500)})) << i;
    const Vec2 out = way * random.uniform(404, 900);
    ASSERT_FALSE(closed(boxes, {out.x(), out.y(), 100})) << i;
  }
}

TEST(ZoneBoxes, AreCutToTheBounds) {
  const BoxMapSpec spec = spec_at(47, 8);
  const ZoneBoxes boxes = zone_boxes(circle(47, 8.2, 60000), "z", {.spec = spec});
  ASSERT_FALSE(boxes.table.boxes.empty());
  EXPECT_LT(boxes.table.boxes.size(), 10U);
  EXPECT_TRUE(closed(boxes, {-1000, -1000, 0}));
  EXPECT_TRUE(closed(boxes, {1000, 1000, 500}));
  EXPECT_TRUE(zone_boxes(circle(47, 9.2, 60000), "z", {.spec = spec}).near.empty());
}

TEST(ZoneBoxes, HoldPolygonsWithHolesInAnyOrder) {
  const BoxMapSpec spec = spec_at(-33, 151);
  ZoneFile file = polygon(spec, {{-600, -600}, {-500, 700}, {800, 650}, {650, -700}});
  file.zones[0].volumes[0].holes.push_back(
      polygon(spec, {{-100, -100}, {100, -100}, {100, 100}}).zones[0].volumes[0].outline.ring);
  const ZoneBoxes boxes = zone_boxes(file, "z", {.spec = spec, .slack = 2});
  EXPECT_TRUE(closed(boxes, {-90, 90, 10}));
  EXPECT_FALSE(closed(boxes, {60, -60, 10}));
  EXPECT_TRUE(closed(boxes, {-104, -104, 10}));
}

TEST(ZoneBoxes, CloseAllThatARingEnclosesThatCrossesItself) {
  const BoxMapSpec spec = spec_at(47, 8);
  const ZoneBoxes boxes =
      zone_boxes(polygon(spec, {{-500, -500}, {500, 500}, {500, -500}, {-500, 500}}), "z",
                 {.spec = spec, .slack = 2});
  EXPECT_TRUE(closed(boxes, {-450, 0, 10}));
  EXPECT_TRUE(closed(boxes, {450, 0, 10}));
  EXPECT_FALSE(closed(boxes, {0, 450, 10}));
}

TEST(ZoneBoxes, CrossTheAntimeridian) {
  const BoxMapSpec spec = spec_at(-17, 179.999);
  ZoneFile file;
  Zone& zone = file.zones.emplace_back();
  zone.volumes.emplace_back().outline.ring = {
      {-17.002, 179.995, 0}, {-17.002, -179.995, 0}, {-16.998, -179.995, 0}, {-16.998, 179.995, 0}};
  const ZoneBoxes boxes = zone_boxes(file, "z", {.spec = spec});
  EXPECT_TRUE(closed(boxes, {0, 0, 10}));
  EXPECT_TRUE(closed(boxes, {400, 0, 10}));
  EXPECT_FALSE(closed(boxes, {0, 400, 10}));
  EXPECT_TRUE(zone_boxes(file, "z", {.spec = spec_at(-17, 0)}).near.empty());
}

TEST(ZoneBoxes, FollowTheGroundOutward) {
  const BoxMapSpec spec = spec_at(47, 8);
  GroundGridSpec grid{.frame = spec.frame,
                      .corner = {-1100, -1100},
                      .cell = 100,
                      .columns = 22,
                      .rows = 22,
                      .error = 1};
  std::vector<double> low;
  std::vector<double> high;
  for (int j = 0; j < 22; ++j) {
    for (int i = 0; i < 22; ++i) {
      low.push_back(10 * i);
      high.push_back(10 * i + 4);
    }
  }
  const GroundModel ground(grid, low, high);
  ZoneFile file = circle(47, 8, 800);
  file.zones[0].volumes[0].lower = HeightLimit{50, HeightReference::ground};
  file.zones[0].volumes[0].upper = HeightLimit{120, HeightReference::ground};
  const ZoneBoxes boxes = zone_boxes(file, "z", {.spec = spec, .ground = &ground, .slack = 5});
  support::Random random(5);
  for (int i = 0; i < 3000; ++i) {
    const Vec2 p(random.uniform(-560, 560), random.uniform(-560, 560));
    const double base = 10 * std::floor((p.x() + 1100) / 100);
    ASSERT_TRUE(closed(boxes, {p.x(), p.y(), base + random.uniform(49, 125)})) << i;
    ASSERT_FALSE(closed(boxes, {p.x(), p.y(), base + 137})) << i;
    ASSERT_FALSE(closed(boxes, {p.x(), p.y(), base + 37})) << i;
  }
}

TEST(ZoneBoxes, TakeALimitWhoseZeroIsNotKnownAsOpen) {
  const BoxMapSpec spec = spec_at(47, 8);
  ZoneFile file = circle(47, 8, 400);
  file.zones[0].volumes[0].lower = HeightLimit{50, HeightReference::sea};
  file.zones[0].volumes[0].upper = HeightLimit{120, HeightReference::ground};
  const ZoneBoxes open = zone_boxes(file, "z", {.spec = spec});
  EXPECT_TRUE(open.near.at(0).open_for_zero);
  EXPECT_TRUE(closed(open, {0, 0, 0}));
  EXPECT_TRUE(closed(open, {0, 0, 500}));
  const GroundModel flat = GroundModel::flat(200);
  const ZoneBoxes known = zone_boxes(
      file, "z", {.spec = spec, .ground = &flat, .sea = ZeroOffset{-20, -19}, .ellipsoid = {}});
  EXPECT_FALSE(known.near.at(0).open_for_zero);
  EXPECT_FALSE(closed(known, {0, 0, 29.9}));
  EXPECT_TRUE(closed(known, {0, 0, 30}));
  EXPECT_TRUE(closed(known, {0, 0, 320}));
  EXPECT_FALSE(closed(known, {0, 0, 320.1}));
}

TEST(ZoneBoxes, CloseAHoleOfTheGroundAtAllHeights) {
  const BoxMapSpec spec = spec_at(47, 8);
  GroundGridSpec grid{
      .frame = spec.frame, .corner = {-1000, -1000}, .cell = 100, .columns = 20, .rows = 20};
  std::vector<double> heights;
  for (int k = 0; k < 400; ++k) heights.push_back(k % 20 >= 10 && k / 20 >= 10 ? std::nan("") : 10);
  const GroundModel ground(grid, heights, heights);
  ZoneFile file = circle(47, 8, 600);
  file.zones[0].volumes[0].upper = HeightLimit{100, HeightReference::ground};
  const ZoneBoxes boxes = zone_boxes(file, "z", {.spec = spec, .ground = &ground});
  EXPECT_TRUE(boxes.near.at(0).open_for_hole);
  EXPECT_TRUE(closed(boxes, {300, 300, 400}));
  EXPECT_FALSE(closed(boxes, {-300, 300, 400}));
}

TEST(ZoneBoxes, ListZonesOfOtherTypesWithoutBoxes) {
  const BoxMapSpec spec = spec_at(47, 8);
  ZoneFile file = circle(47, 8, 400);
  file.zones[0].type = ZoneType::conditional;
  const ZoneBoxes boxes = zone_boxes(file, "z", {.spec = spec, .types = {ZoneType::prohibited}});
  ASSERT_EQ(boxes.near.size(), 1U);
  EXPECT_EQ(boxes.near[0].boxes, 0U);
  EXPECT_TRUE(boxes.table.boxes.empty());
}

TEST(ZoneBoxes, AreThereAtTheirTimesAlone) {
  BoxMapSpec spec = spec_at(47, 8);
  spec.epoch = "2026-05-04T00:00:00Z";
  ZoneFile file = circle(47, 8, 400);
  file.zones[0].periods = {
      {.start = "2026-05-04T08:00:00Z", .end = "2026-05-04T09:00:00Z", .schedule = {}}};
  const ZoneBoxes boxes = zone_boxes(file, "z", {.spec = spec, .clock = {spec.epoch, 3}});
  ASSERT_FALSE(boxes.table.boxes.empty());
  EXPECT_EQ(boxes.table.time(0), (TimeSpan{8 * 3600, 9 * 3600}));
  EXPECT_EQ(boxes.near[0].times, std::vector<TimeSpan>{boxes.table.time(0)});
}

TEST(ZoneBoxes, RefuseAMapThatIsNowhereOnEarth) {
  BoxMapSpec spec = spec_at(47, 8);
  spec.frame.origin.reset();
  EXPECT_THROW(zone_boxes(circle(47, 8, 400), "z", {.spec = spec}), InputError);
}

}  // namespace
}  // namespace geom
