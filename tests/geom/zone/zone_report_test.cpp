#include "geom/zone/zone_report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "geom/map/derive.h"
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

// What was removed may have been theirs; zones of the same step, and later ones, are whole.
TEST(ZoneSources, AreForgottenWhereBoxesWereRemovedAfterThem) {
  BoxTable table;
  table.add({{1, 1, 0}, {2, 2, 5}}, 0);
  table.add({{3, 1, 0}, {4, 2, 5}}, 1);
  table.add({{5, 1, 0}, {6, 2, 5}}, 2);
  const BoxMap map({.frame = {}, .bounds = {{0, 0, 0}, {9, 9, 9}}, .bounds_from = "source"}, table);
  MapPatch first(map, "city.boxmap");
  first.note("zones", to_json(example()));
  const BoxMap closed = first.made();
  MapPatch removal(closed, "city.boxmap");
  removal.remove({1});
  const BoxMap open = removal.made();
  EXPECT_TRUE(zone_sources(open.spec()).empty());
  const BoxMap joined = join(std::vector<SourceMap>{{"a", open}, {"b", closed}});
  EXPECT_EQ(zone_sources(joined.spec()).size(), 1U);
  MapPatch again(open, "city.boxmap");
  again.remove({0});
  again.note("zones", to_json(example()));
  EXPECT_EQ(zone_sources(again.made().spec()).size(), 1U);
}

}  // namespace
}  // namespace geom
