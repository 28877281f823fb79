#include "geom/map/box_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "geom/base/error.h"
#include "support/random_city.h"

namespace geom {
namespace {

TEST(BoxMap, EveryBoxLivesInOneTileThatCoversIt) {
  const BoxMap map = support::random_city(5, 500, 900);
  std::size_t next = 0;
  for (const Tile& tile : map.tiles()) {
    EXPECT_EQ(tile.first, next);
    next += tile.count;
    for (const Aabb& box : map.boxes().subspan(tile.first, tile.count)) {
      EXPECT_EQ(merged(tile.extent, box), tile.extent);
      if (tile.large) continue;
      EXPECT_EQ(std::floor(box.min.x() / 100), tile.ix);
    }
  }
  EXPECT_EQ(next, map.boxes().size());
  EXPECT_TRUE(map.tiles().front().large);
}

TEST(BoxMap, TheHashIsOfTheTimesToo) {
  const std::vector<Aabb> boxes = {{{0, 0, 0}, {1, 1, 1}}, {{5, 5, 0}, {6, 6, 9}}};
  BoxMapSpec spec;
  spec.bounds = {{0, 0, 0}, {10, 10, 10}};
  const std::string untimed = BoxMap(spec, support::table_of(boxes)).hash();
  spec.epoch = "2026-05-04T06:30:00Z";
  EXPECT_EQ(BoxMap(spec, support::table_of(boxes)).hash(), untimed);
  std::set<std::string> hashes{untimed};
  const auto timed = [&](std::size_t box, const TimeSpan& span) {
    BoxTable table = support::table_of(boxes);
    table.set_time(box, span);
    return BoxMap(spec, table);
  };
  for (const std::size_t box : {0u, 1u}) {
    for (const TimeSpan& span : {TimeSpan{0, 9}, TimeSpan{0, 9.5}, TimeSpan{-1, 9}}) {
      EXPECT_TRUE(hashes.insert(timed(box, span).hash()).second);
      EXPECT_EQ(timed(box, span).time(box), span);
      EXPECT_TRUE(timed(box, span).time(1 - box).always());
    }
  }
  spec.epoch = "2026-05-04T06:30:01Z";
  EXPECT_TRUE(hashes.insert(timed(0, {0, 9}).hash()).second);
  const std::string whole = timed(1, {0, 9}).hash();
  spec.tile_size = 3;
  EXPECT_EQ(timed(1, {0, 9}).hash(), whole);
  EXPECT_EQ(timed(1, {-0.0, 9}).hash(), whole);
  spec.epoch.reset();
  EXPECT_THROW(timed(0, {0, 9}), InputError);
  spec.epoch = "2026-05-04T06:30:00Z";
  EXPECT_THROW(timed(0, {9, 0}), InputError);
  EXPECT_THROW(timed(0, {std::nan(""), 9}), InputError);
}

}  // namespace
}  // namespace geom
