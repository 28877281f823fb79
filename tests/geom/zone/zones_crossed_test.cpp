#include "geom/zone/zones_crossed.h"

#include <gtest/gtest.h>

#include "geom/base/error.h"

namespace geom {
namespace {

BoxMapSpec spec() {
  BoxMapSpec out{.frame = {}, .bounds = {{-1000, -1000, 0}, {1000, 1000, 200}}};
  out.frame.origin = GeodeticOrigin{47, 8, 0};
  out.epoch = "2026-05-04T00:00:00Z";
  return out;
}

ZoneFile two_zones() {
  ZoneFile file;
  for (const double latitude : {47.0, 47.003}) {
    Zone& zone = file.zones.emplace_back();
    zone.type = latitude == 47 ? ZoneType::none : ZoneType::prohibited;
    zone.volumes.emplace_back().outline.centre = {latitude, 8, 0};
    zone.volumes[0].outline.radius = 100;
    zone.periods = {
        {.start = "2026-05-04T08:00:00Z", .end = "2026-05-04T09:00:00Z", .schedule = {}}};
  }
  return file;
}

std::vector<CrossedZone> crossed(const std::vector<PlacedTime>& flight) {
  const BoxMapSpec where = spec();
  return zones_crossed(two_zones(), "z", {.spec = where, .clock = {where.epoch, 2}}, flight);
}

TEST(ZonesCrossed, AreThoseOfAnyTypeThatAPartMeetsInSpaceAndTime) {
  const double eight = 8 * 3600;
  const Aabb middle{{-5, -5, 50}, {5, 5, 60}};
  const Aabb north{{-5, 330, 50}, {5, 340, 60}};
  const auto found = crossed({{middle, {eight - 60, eight + 10}},
                              {middle, {eight + 10, eight + 20}},
                              {north, {eight + 20, eight + 30}}});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].index, 0U);
  EXPECT_EQ(found[0].time, (TimeSpan{eight, eight + 20}));
  EXPECT_EQ(found[1].time, (TimeSpan{eight + 20, eight + 30}));
  EXPECT_TRUE(crossed({{middle, {0, 60}}}).empty());
  EXPECT_TRUE(crossed({{{{400, 400, 0}, {500, 500, 9}}, {eight, eight}}}).empty());
}

TEST(ZonesCrossed, RefuseAFlightThatLeavesTheBounds) {
  EXPECT_THROW(crossed({{{{-5, -5, 50}, {1005, 5, 60}}, {0, 60}}}), InputError);
}

}  // namespace
}  // namespace geom
