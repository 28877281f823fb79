#include "geom/import/skipped.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>
#include <sstream>

#include "geom/base/error.h"
#include "geom/import/block_text.h"
#include "geom/import/city_json.h"
#include "geom/import/fcnd_csv.h"
#include "geom/import/world_json.h"
#include "support/cases.h"

namespace {

TEST(Skipped, NamesTheFirstOfEachKind) {
  geom::Skipped skipped;
  EXPECT_TRUE(skipped.empty());
  for (int i = 1; i <= 5; ++i) skipped.add("b", fmt::format("line {}", i));
  skipped.add("a", "x");
  EXPECT_EQ(skipped.count(), 6u);
  EXPECT_EQ(skipped.text(), "1 x a (x), 5 x b (line 1, line 2, line 3, …)");
}

// What a table says, or that it was refused.
template <class Read>
std::pair<std::size_t, std::size_t> built_and_skipped(const Read& read, const std::string& text) {
  std::istringstream in(text);
  const auto out = read(in, "t");
  return {out.table.boxes.size(), out.skipped.count()};
}

// Ten thousand block texts of which some lines are misspelt: each block is built, refused or
// counted.
TEST(BlockText, NoLineIsLost) {
  std::mt19937 random(3);
  const std::string wrong[] = {"blok",   "Block",  "block:", "BLOCK",
                               "blocks", "window", "b",      "bl ock"};
  for (int i = 0; i < support::cases(10000); ++i) {
    std::string text = "boundary 0 0 0 9 9 9\nblock 0 0 0 1 1 1\n";
    std::size_t built = 1;
    std::size_t odd = 0;
    for (std::size_t k = random() % 6; k > 0; --k) {
      const bool right = random() % 2;
      ++(right ? built : odd);
      text += (right ? "block" : wrong[random() % 8]) + " 1 1 1 2 2 2\n";
    }
    ASSERT_EQ(built_and_skipped(geom::read_block_text, text), (std::pair{built, odd})) << text;
  }
}

TEST(WorldJson, KeysThatMayTurnOrAddBlocksAreSkipped) {
  const auto world = [](const std::string& more, const std::string& in_block) {
    return R"({"bounds":{"extents":[0,9,0,9,0,9]},"blocks":[{"extents":[1,2,1,2,1,2])" + in_block +
           "}]" + more + "}";
  };
  EXPECT_EQ(built_and_skipped(geom::read_world_json, world("", "")).second, 0u);
  EXPECT_EQ(
      built_and_skipped(geom::read_world_json, world(",\"start\":[1,1,1]", ",\"colour\":1")).second,
      0u);
  EXPECT_EQ(built_and_skipped(geom::read_world_json, world(",\"spheres\":[]", "")).second, 1u);
  EXPECT_EQ(built_and_skipped(geom::read_world_json, world("", ",\"rotation\":45")).second, 1u);
}

TEST(FcndCsv, ColumnsThatTurnBoxesAndFieldsWithoutOneAreSkipped) {
  const std::string header = "posX,posY,posZ,halfSizeX,halfSizeY,halfSizeZ";
  EXPECT_EQ(built_and_skipped(geom::read_fcnd_csv, header + ",label\n1,1,1,1,1,1,hut\n").second,
            0u);
  EXPECT_EQ(built_and_skipped(geom::read_fcnd_csv, header + ",Yaw\n1,1,1,1,1,1,0.5\n").second, 1u);
  EXPECT_EQ(built_and_skipped(geom::read_fcnd_csv, "1,5,1,5,1,5,2,5\n").second, 2u);
  EXPECT_EQ(built_and_skipped(geom::read_fcnd_csv, "1,5,1,5,1,5,,\n").second, 0u);
}

geom::CityJson city(const std::string& objects) {
  std::istringstream in(R"({"type":"CityJSON","version":"2.0","CityObjects":{)" + objects +
                        R"(},"vertices":[[0,0,5],[9,0,7],[0,9,6],[9,9,8],[0,0,0]]})");
  return geom::read_city_json(in, "t");
}

TEST(CityJson, TerrainIsGroundAndBuilt) {
  const auto out = city(
      R"("t":{"type":"TINRelief","geometry":[{"type":"CompositeSurface","lod":"1","boundaries":[[[0,1,2]],[[1,3,2]]]}]})");
  ASSERT_EQ(out.footprints.size(), 2u);
  EXPECT_TRUE(out.footprints[0].ground);
  EXPECT_EQ(out.footprints[1].bottom, 5);
  EXPECT_EQ(out.footprints[1].top, 8);
}

TEST(CityJson, ObjectsWithoutSurfacesAreSkippedUnlessTheirChildrenHaveThem) {
  const std::string part =
      R"("p":{"type":"BuildingPart","geometry":[{"type":"MultiSurface","lod":"1","boundaries":[[[0,1,2]]]}]})";
  EXPECT_EQ(city(R"("b":{"type":"Building","children":["p"]},)" + part).skipped.count(), 0u);
  EXPECT_EQ(city(R"("b":{"type":"Building"},)" + part).skipped.count(), 1u);
  EXPECT_EQ(
      city(
          R"("b":{"type":"Bridge","geometry":[{"type":"MultiPoint","lod":"1","boundaries":[0]}]},)" +
          part)
          .skipped.count(),
      1u);
  EXPECT_EQ(city(R"("r":{"type":"Road"},)" + part).skipped.count(), 0u);
}

}  // namespace
