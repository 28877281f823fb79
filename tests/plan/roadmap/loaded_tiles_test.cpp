#include "roadmap/loaded_tiles.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "geom/base/error.h"
#include "plan/scenes.h"
#include "roadmap/tiled.h"

namespace plan {
namespace {

geom::CollisionScene wide_scene() { return random_scene(3, 80, 900, {0.5, 0.5, 0.25}); }

// All bends below a node, opening what is closed; none is nearer to `p` than the boxes around it.
void open_all(LoadedTiles& tiles, std::uint32_t at, const Vec3& p, double least,
              std::vector<Vec3>& met) {
  least = std::max(least, BendTree::distance(tiles.node(at), p));
  const BendTree::Node node = tiles.opened(at);
  for (std::uint32_t k = node.first; k < node.first + node.count; ++k) {
    if (!node.leaf) {
      open_all(tiles, k, p, least, met);
      continue;
    }
    met.push_back(tiles.bends()[k].position);
    ASSERT_LE(least, (met.back() - p).norm());
  }
}

bool lower(const Vec3& a, const Vec3& b) {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
}

TEST(LoadedTiles, HaveEachBendBelowTheRootOnce) {
  const auto scene = wide_scene();
  const Roadmap roadmap = build_roadmap(scene, {10, 60, {}});
  ASSERT_GT(roadmap.tiles(), 16u);
  LoadedTiles tiles(roadmap);
  EXPECT_TRUE(tiles.bends().empty());
  std::vector<Vec3> met;
  open_all(tiles, tiles.root(), {120, 340, 5}, 0, met);
  std::vector<Vec3> all;
  for (std::size_t i = 0; i < roadmap.bends(); ++i) all.push_back(roadmap.bend(i).position);
  std::sort(met.begin(), met.end(), lower);
  std::sort(all.begin(), all.end(), lower);
  EXPECT_EQ(met, all);
}

// In whatever order they are loaded.
TEST(LoadedTiles, EdgesLeadWhereTheRoadmapSays) {
  const auto scene = wide_scene();
  const Roadmap roadmap = build_roadmap(scene, {10, 60, {}});
  const auto [flat, edges] = flattened(roadmap);
  LoadedTiles tiles(roadmap);
  std::vector<Vec3> met;
  open_all(tiles, tiles.root(), {0, 0, 0}, 0, met);
  for (std::uint32_t i = 0; i < tiles.bends().size(); i += 3) {
    const Vec3 p = tiles.bends()[i].position;
    const auto at = std::find_if(flat.bends.begin(), flat.bends.end(), [&](const Bend& bend) {
      return bend.position == p && bend.axis == tiles.bends()[i].axis &&
             bend.outward == tiles.bends()[i].outward;
    });
    ASSERT_NE(at, flat.bends.end());
    const auto expected = edges.of(static_cast<std::size_t>(at - flat.bends.begin()));
    const LoadedTiles::Edges found = tiles.edges_of(i);
    ASSERT_EQ(found.first.size() + found.second.size(), expected.size());
    for (std::size_t e = 0; e < expected.size(); ++e) {
      const std::uint32_t edge =
          e < found.first.size() ? found.first[e] : found.second[e - found.first.size()];
      const std::uint32_t j = tiles.target(found.tile, edge);
      ASSERT_EQ(tiles.bends()[j].position, flat.bends[expected[e]].position);
    }
  }
}

// A file may say anything: whatever is read is refused, and nothing crashes.
TEST(LoadedTiles, RefuseWhatCannotBe) {
  const auto scene = wide_scene();
  const Roadmap good = build_roadmap(scene, {10, 60, {}});
  const auto refused = [&](const auto& spoil) {
    Roadmap roadmap = good;
    spoil(roadmap);
    EXPECT_THROW(
        {
          LoadedTiles tiles(roadmap);
          std::vector<Vec3> met;
          open_all(tiles, tiles.root(), {0, 0, 0}, 0, met);
        },
        geom::InputError);
  };
  const auto changed = [](auto& array, std::size_t at, auto value) {
    std::vector copy(array.begin(), array.end());
    copy[at] = value;
    array = copy;
    return copy;  // moved: what `array` refers to stays
  };
  std::vector<std::int32_t> index;
  std::vector<float> extent;
  std::vector<std::uint64_t> first;
  std::vector<double> position;
  std::vector<std::uint32_t> split;
  std::vector<std::int8_t> axis;
  const std::size_t tiles = good.tiles();
  index.resize(2 * tiles);
  refused([&](Roadmap& r) { r.tile_index = index; });
  refused([&](Roadmap& r) { extent = changed(r.tile_extent, 6, 1e30f); });
  refused([&](Roadmap& r) { extent = changed(r.tile_extent, 8, std::nanf("")); });
  refused([&](Roadmap& r) { first = changed(r.tile_first, 1, std::uint64_t{1} << 60); });
  refused([&](Roadmap& r) { first = changed(r.tile_edges, tiles, r.edge_to.size() + 1); });
  refused([&](Roadmap& r) { position = changed(r.bend_position, 7, std::nan("")); });
  refused([&](Roadmap& r) { axis = changed(r.bend_axis, 5, std::int8_t{3}); });
  refused([&](Roadmap& r) { axis = changed(r.bend_outward, 5, std::int8_t{0}); });
  refused([&](Roadmap& r) { split = changed(r.edge_split, 4, 0xffffffffu); });
  refused([&](Roadmap& r) { split = changed(r.edge_first, 4, 0xffffffffu); });
}

}  // namespace
}  // namespace plan
