#include "geom/map/box_map.h"

#include <gtest/gtest.h>

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

TEST(BoxMap, TheHashIsOfTheContentAndNotOfItsOrderOrTiles) {
  BoxTable table = support::table_of({{{0, 0, 0}, {1, 1, 1}}, {{5, 5, 0}, {6, 6, 9}}});
  BoxMapSpec spec;
  spec.bounds = {{0, 0, 0}, {10, 10, 10}};
  const BoxMap one(spec, table);
  std::swap(table.boxes[0], table.boxes[1]);
  spec.tile_size = 3;
  EXPECT_EQ(one.hash(), BoxMap(spec, table).hash());
  spec.bounds.max.z() = 11;
  EXPECT_NE(one.hash(), BoxMap(spec, table).hash());
}

}  // namespace
}  // namespace geom
