#include "collision/tile_groups.h"

#include <gtest/gtest.h>

#include <limits>

#include "geom/base/error.h"
#include "map/box_map_data.h"
#include "support/random_city.h"

namespace geom {
namespace {

TileGroups groups_of(const BoxMap& map, double wanted) {
  return tile_groups(map.data().tiles, map.size(), wanted);
}

// How many boxes a group has; its extent must hold them, and its runs must go on in the map.
std::size_t count(const TileGroups& groups, std::size_t g, const BoxMap& map,
                  std::vector<int>& seen) {
  std::size_t out = 0;
  std::size_t last = 0;
  for (std::uint32_t r = groups.head[g]; r != TileGroups::kEnd; r = groups.runs[r].next) {
    const TileGroups::Run& run = groups.runs[r];
    EXPECT_TRUE(out == 0 || run.first > last);
    last = run.first + run.count;
    for (std::size_t i = run.first; i < last; ++i) {
      ++seen[i];
      EXPECT_TRUE(contains(groups.extent[g], map.boxes()[i].min));
      EXPECT_TRUE(contains(groups.extent[g], map.boxes()[i].max));
    }
    out += run.count;
  }
  return out;
}

TEST(TileGroups, HaveEachBoxOnce) {
  for (const double wanted : {1.0, 3.0, 20.0, 1000.0}) {
    const BoxMap map = support::random_city(5, 900, 1500, {-300, 200, 0});
    const TileGroups groups = groups_of(map, wanted);
    std::vector<int> seen(map.size());
    ASSERT_EQ(groups.head.size(), groups.extent.size());
    for (std::size_t g = 0; g < groups.head.size(); ++g) {
      EXPECT_GT(count(groups, g, map, seen), 0u);
    }
    EXPECT_EQ(seen, std::vector<int>(map.size(), 1));
  }
}

TEST(TileGroups, HaveAboutAsManyBoxesAsWanted) {
  const BoxMap map = support::random_city(5, 9000, 3000);
  const TileGroups groups = groups_of(map, 60);
  EXPECT_GT(groups.head.size(), 9000u / 200);
  EXPECT_LT(groups.head.size(), 9000u / 30);
}

TEST(TileGroups, AreSquaresOfTiles) {
  const BoxMap map = support::random_city(6, 3000, 2000, {123, -77, 0});
  const TileGroups groups = groups_of(map, 40);
  for (const Aabb& extent : groups.extent) {
    const Vec3 size = extent.max - extent.min;
    // But for the one of large boxes.
    EXPECT_TRUE(size.x() < 450 || size.y() <= 4) << size.transpose();
  }
}

TEST(TileGroups, AreOneWhereThereAreFewBoxes) {
  const BoxMap map = support::random_city(6, 300, 1000);
  const TileGroups groups = groups_of(map, 40);
  ASSERT_EQ(groups.head.size(), 1u);
  EXPECT_EQ(groups.runs.size(), 1u);
  EXPECT_EQ(groups.runs[0].count, map.size());
}

TEST(TileGroups, OfNoTilesAreNone) { EXPECT_TRUE(tile_groups({}, 0, 512).head.empty()); }

// Names of boxes within a group are 31 bits.
TEST(TileGroups, SpanNoMoreOfTheMapThanNamesReach) {
  constexpr std::size_t kMany = std::size_t{1} << 30;
  const Aabb box{{0, 0, 0}, {1, 1, 1}};
  TileTable tiles;
  tiles.set({{0, 0, false, box, 0, kMany},
             {1, 0, false, box, kMany, kMany},
             {2, 0, false, box, 2 * kMany, kMany}});
  const TileGroups groups = tile_groups(tiles, 3 * kMany, 4.0 * kMany);
  ASSERT_EQ(groups.head.size(), 3u);
  for (std::size_t g = 0; g < 3; ++g) EXPECT_EQ(groups.runs[groups.head[g]].first, g * kMany);
}

TEST(TileGroups, RefuseAnExtentThatIsNone) {
  TileTable tiles;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  tiles.set({{0, 0, false, {{0, nan, 0}, {1, 1, 1}}, 0, 1}});
  EXPECT_THROW(tile_groups(tiles, 1, 512), InputError);
}

}  // namespace
}  // namespace geom
