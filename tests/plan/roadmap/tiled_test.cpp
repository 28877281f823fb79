#include "roadmap/tiled.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "plan/scenes.h"
#include "roadmap/bends.h"
#include "roadmap/tile_reader.h"
#include "support/random_city.h"

namespace plan {
namespace {

class TiledProperty : public testing::TestWithParam<std::uint64_t> {};

// Against all pairs, over the borders of several tiles.
TEST_P(TiledProperty, HasAllEdgesThatThereAre) {
  const auto scene = small_city(GetParam());
  const auto [tiles, edges] = flattened(build_roadmap(scene, {10, 70, {}}, {2, {}}));
  ASSERT_GT(tiles.squares.size(), 3u);
  const std::vector<Bend>& bends = tiles.bends;
  for (std::uint32_t i = 0; i < bends.size(); i += 7) {
    const auto there = edges.of(i);
    for (std::uint32_t j = 0; j < bends.size(); ++j) {
      if (i == j) continue;
      const bool found = std::find(there.begin(), there.end(), j) != there.end();
      ASSERT_EQ(linked(scene, bends[i], bends[j], 70), found) << i << " " << j;
    }
  }
}

TEST_P(TiledProperty, ComesBackAsItWas) {
  const auto scene = small_city(GetParam());
  const Roadmap roadmap = build_roadmap(scene, {10, 70, {}});
  const FlatRoadmap flat = flattened(roadmap);
  const Roadmap back = tiled(roadmap.spec, flat.tiles, 0, flat.tiles.squares.size(), flat.edges, 2);
  EXPECT_TRUE(std::ranges::equal(back.tile_index, roadmap.tile_index));
  EXPECT_TRUE(std::ranges::equal(back.tile_extent, roadmap.tile_extent));
  EXPECT_TRUE(std::ranges::equal(back.tile_first, roadmap.tile_first));
  EXPECT_TRUE(std::ranges::equal(back.tile_edges, roadmap.tile_edges));
  EXPECT_TRUE(std::ranges::equal(back.bend_position, roadmap.bend_position));
  EXPECT_TRUE(std::ranges::equal(back.edge_first, roadmap.edge_first));
  EXPECT_TRUE(std::ranges::equal(back.edge_split, roadmap.edge_split));
  EXPECT_TRUE(std::ranges::equal(back.edge_to, roadmap.edge_to));
}

INSTANTIATE_TEST_SUITE_P(Cities, TiledProperty, testing::Values(1, 2, 3));

}  // namespace
}  // namespace plan
