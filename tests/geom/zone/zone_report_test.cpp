#include "geom/zone/zone_report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "geom/map/map_patch.h"

namespace geom {
namespace {

ZoneSource example() {
  ZoneSource source;
  source.file = "zones.json";
  source.hash = "sha256:12";
  source.format = "ed-269";
  source.issued = "2026-05-01";
  source.zones_read = 7;
  ListedZone zone{.identifier = "CH-1", .name = "Port", .type = ZoneType::conditional, .boxes = 3};
  zone.times = {{.from = 60, .until = 120}, {.from = 500, .until = TimeSpan{}.until}};
  zone.authority = "Police";
  zone.message = "Ask first";
  source.zones = {zone};
  return source;
}

TEST(ZoneSources, ComeBackFromAMapsHistory) {
  BoxTable table;
  table.add({{1, 1, 0}, {2, 2, 5}}, 0);
  const BoxMap map({.frame = {}, .bounds = {{0, 0, 0}, {9, 9, 9}}, .bounds_from = "source"}, table);
  EXPECT_TRUE(zone_sources(map.spec()).empty());
  MapPatch patch(map, "city.boxmap");
  patch.note("zones", to_json(example()));
  const std::vector<ZoneSource> back = zone_sources(patch.made().spec());
  ASSERT_EQ(back.size(), 1U);
  EXPECT_EQ(back[0].hash, "sha256:12");
  EXPECT_EQ(back[0].issued, "2026-05-01");
  EXPECT_EQ(back[0].zones_read, 7U);
  ASSERT_EQ(back[0].zones.size(), 1U);
  const ListedZone& zone = back[0].zones[0];
  EXPECT_EQ(zone.type, ZoneType::conditional);
  EXPECT_EQ(zone.boxes, 3U);
  EXPECT_EQ(zone.times, example().zones[0].times);
  EXPECT_EQ(zone.authority, "Police");
  EXPECT_EQ(zone.message, "Ask first");
}

}  // namespace
}  // namespace geom
