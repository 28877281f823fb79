#include "roadmap/tile_reader.h"

#include <gtest/gtest.h>

#include "geom/base/error.h"
#include "plan/scenes.h"

namespace plan {
namespace {

TEST(TileReader, FindsTheTilesThatThereAre) {
  const auto scene = random_scene(3, 80, 900, {0.5, 0.5, 0.25});
  const Roadmap roadmap = build_roadmap(scene, {10, 60, {}});
  const TileReader reader(roadmap);
  std::size_t found = 0;
  for (std::int32_t row = -2; row < 12; ++row) {
    for (std::int32_t column = -2; column < 12; ++column) {
      const auto tile = reader.find({column, row});
      if (!tile) continue;
      ++found;
      EXPECT_EQ(reader.square(*tile), (Square{column, row}));
      const geom::Aabb extent = reader.extent(*tile);
      const TileReader::Range bends = reader.bends(*tile);
      EXPECT_GT(bends.size(), 0u);
      for (std::size_t i = bends.begin; i < bends.end; ++i) {
        const Vec3 p = reader.bend(i).position;
        EXPECT_EQ(reader.squares().of(p), (Square{column, row}));
        EXPECT_TRUE((extent.min.array() <= p.array()).all());
        EXPECT_TRUE((p.array() <= extent.max.array()).all());
      }
    }
  }
  EXPECT_EQ(found, roadmap.tiles());
}

TEST(TileReader, RefusesAnEdgeToATileOrBendThatIsNotThere) {
  const auto scene = random_scene(3, 80, 900, {0.5, 0.5, 0.25});
  const Roadmap roadmap = build_roadmap(scene, {10, 60, {}});
  const TileReader reader(roadmap);
  const std::uint32_t here = 4u << Squares::kLocalBits;  // of 3 x 3 squares
  EXPECT_EQ(reader.target(2, here).tile, 2u);
  EXPECT_THROW(reader.target(2, here | static_cast<std::uint32_t>(reader.bends(2).size())),
               geom::InputError);
  EXPECT_THROW(reader.target(2, 9u << Squares::kLocalBits), geom::InputError);
  EXPECT_THROW(reader.target(0, 255u << Squares::kLocalBits), geom::InputError);
}

}  // namespace
}  // namespace plan
