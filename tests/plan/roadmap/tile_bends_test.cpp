#include "roadmap/tile_bends.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

#include "plan/scenes.h"
#include "roadmap/bends.h"
#include "support/random_city.h"

namespace plan {
namespace {

using Key = std::tuple<double, double, double, int, int, int>;

std::vector<Key> sorted(const std::vector<Bend>& bends) {
  std::vector<Key> out;
  for (const Bend& b : bends) {
    const Vec3& p = b.position;
    out.emplace_back(p.x(), p.y(), p.z(), b.axis, b.outward[0], b.outward[1]);
  }
  std::sort(out.begin(), out.end());
  return out;
}

TileBends all_tiles(const geom::CollisionScene& scene, const RoadmapSpec& spec) {
  std::vector<std::uint64_t> codes;
  for (const SquareShare& share : squares_of(scene, spec)) codes.push_back(share.code);
  return bends_of(scene, spec, codes, {2, {}});
}

class TileBendsProperty : public testing::TestWithParam<std::uint64_t> {};

// Made without tiles: around one box after the other.
TEST_P(TileBendsProperty, HasEachBendInOneTile) {
  const auto scene = small_city(GetParam());
  const std::vector<Bend> tiled = all_tiles(scene, {10, 20, {}}).bends;
  std::vector<Bend> plain;
  for (std::size_t i = 0; i < scene.map().size(); ++i) {
    add_bends(scene, scene.grown(i), 10, std::nullopt, plain);
  }
  EXPECT_EQ(sorted(tiled), sorted(plain));
}

// A long wall and a slab over all of it have bends in many squares, each found in its own alone.
TEST(TileBends, AreFoundAlongBoxesOfManySquares) {
  const auto scene = scene_of({{{-1500, -700, 20}, {1430, 900, 21}},
                               {{-1200, 10, 0}, {1300, 12, 9}},
                               {{100, 5, 0}, {120, 30, 30}}},
                              {{-2000, -2000, 0}, {2000, 2000, 60}}, {1, 1, 1});
  for (const double part : {3.0, 10.0, 400.0}) {
    const TileBends tiles = all_tiles(scene, {part, 20, {}});
    std::vector<Bend> plain;
    for (std::size_t i = 0; i < 3; ++i) {
      add_bends(scene, scene.grown(i), part, std::nullopt, plain);
    }
    EXPECT_EQ(sorted(tiles.bends), sorted(plain)) << part;
    const Squares squares(20);
    for (std::size_t i = 0; i < tiles.bends.size(); ++i) {
      EXPECT_EQ(squares.of(tiles.bends[i].position), tiles.squares[tiles.tile_of(i)]);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Cities, TileBendsProperty, testing::Values(1, 2, 3));

}  // namespace
}  // namespace plan
