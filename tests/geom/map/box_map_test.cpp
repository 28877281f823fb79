#include "geom/map/box_map.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "geom/archive/box_map_file.h"
#include "geom/base/error.h"
#include "support/edited_map.h"
#include "support/random_city.h"

namespace geom {
namespace {

using support::file_of;

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

TEST(BoxMapFile, ReadsBackWhatWasWrittenByteForByte) {
  const BoxMap map = support::random_city(6, 200, 500);
  const auto bytes = file_of(map);
  const BoxMap back = read_box_map(ArrayArchive::from_bytes(bytes, "m"));
  EXPECT_EQ(back.hash(), map.hash());
  EXPECT_TRUE(
      std::equal(back.boxes().begin(), back.boxes().end(), map.boxes().begin(), map.boxes().end()));
  EXPECT_EQ(file_of(back), bytes);
}

TEST(BoxMapFile, HostileBytesAreRefusedOrLoadAsSoundMaps) {
  const auto good = file_of(support::random_city(7, 5, 50));
  support::Random random(8);
  int refused = 0;
  for (int i = 0; i < 4000; ++i) {
    auto bytes = good;
    for (int k = 0; k < 3; ++k)
      bytes[random.below(static_cast<int>(bytes.size()))] = std::byte(random.below(256));
    if (i % 4 == 0) bytes.resize(random.below(static_cast<int>(bytes.size())));
    try {
      const BoxMap map = read_box_map(ArrayArchive::from_bytes(bytes, "m"));
      for (const Aabb& box : map.boxes()) ASSERT_TRUE((box.min.array() <= box.max.array()).all());
    } catch (const InputError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 1000);
}

}  // namespace
}  // namespace geom
