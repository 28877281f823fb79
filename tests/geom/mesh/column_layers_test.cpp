#include "mesh/column_layers.h"

#include <gtest/gtest.h>

#include "support/triangle_shapes.h"

namespace geom {
namespace {

const CoverGrid kGrid{1, 0.5, 1e-9};

TEST(JoinLayers, JoinsWhatIsNowhereFurtherThanTheRise) {
  const JoinLayers join{0.5};
  ColumnLayers into = {{0, 0, 1, 1}, {5, 5.1, 6, 6}};
  EXPECT_TRUE(join(into, {{0.2, 0.4, 1.2, 1.3}, {5, 5, 6, 6}}));
  EXPECT_EQ(into[0].low, 0);
  EXPECT_EQ(into[0].low_most, 0.4);
  EXPECT_EQ(into[0].high_least, 1);
  EXPECT_EQ(into[0].high, 1.3);
  EXPECT_FALSE(join(into, {{0.6, 0.6, 1.2, 1.3}, {5, 5, 6, 6}})) << "too high";
  EXPECT_FALSE(join(into, {{0.2, 0.4, 1.2, 1.3}})) << "another number";
  EXPECT_FALSE(join(into, {{0, 0, 1, 1}, {5, 5, 6, 6.6}})) << "reaches too far";
  EXPECT_EQ(into[0].high, 1.3) << "left alone";
}

// Runs over cells 0 to 4 of row 0 at the heights given, of a flat cuboid of 4 x 1 m.
std::vector<SurfaceRun> runs_at(const std::vector<std::array<double, 2>>& heights) {
  std::vector<SurfaceRun> runs;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    const auto [low, high] = heights[i];
    runs.push_back({0, {0, 4}, low, low, high, high, static_cast<std::uint32_t>(i)});
  }
  return runs;
}

std::vector<Aabb> boxes(const std::vector<SurfaceRun>& runs, SolidFill fill, double down_to = 0) {
  const TriangleMesh mesh = support::cuboid({{0, 0, 0}, {4, 1, 9}});  // 0, 1: bottom; 2, 3: top
  SolidGroup group{fill, down_to, {{0, 0, -9}, {4, 1, 9}}};
  return LayerBoxes(mesh, kGrid, group).boxes(runs);
}

TEST(LayerBoxes, LeaveGapsThatAreFree) {
  const auto found = boxes(runs_at({{0, 0}, {0, 1}, {5, 9}}), SolidFill::none);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0], (Aabb{{0, 0, 0}, {4, 1, 1}}));
  EXPECT_EQ(found[1], (Aabb{{0, 0, 5}, {4, 1, 9}}));
}

TEST(LayerBoxes, LeaveNoGapOfTwiceTheRise) {
  EXPECT_EQ(boxes(runs_at({{0, 1}, {2, 3}}), SolidFill::none).size(), 1u);
  EXPECT_EQ(boxes(runs_at({{0, 1}, {2.01, 3}}), SolidFill::none).size(), 2u);
}

TEST(LayerBoxes, FillWhatASurfaceWindsAround) {
  const auto found = boxes(runs_at({{0, 0}, {0, 0}, {9, 9}, {9, 9}}), SolidFill::inside);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0], (Aabb{{0, 0, 0}, {4, 1, 9}}));
}

TEST(LayerBoxes, FillDownOrUpToAHeight) {
  const auto down = boxes(runs_at({{3, 4}}), SolidFill::down_to, -2);
  ASSERT_EQ(down.size(), 1u);
  EXPECT_EQ(down[0], (Aabb{{0, 0, -2}, {4, 1, 4}}));
  const auto up = boxes(runs_at({{3, 4}}), SolidFill::down_to, 8);
  ASSERT_EQ(up.size(), 1u);
  EXPECT_EQ(up[0], (Aabb{{0, 0, 3}, {4, 1, 8}}));
}

TEST(LayerBoxes, AreCutWhereARunBeginsOrEnds) {
  std::vector<SurfaceRun> runs = runs_at({{0, 0}});
  runs.push_back({0, {2, 3}, 5, 5, 5, 5, 1});
  runs.push_back({2, {0, 4}, 0, 0, 0, 0, 0});
  EXPECT_EQ(boxes(runs, SolidFill::none).size(), 4u) << "the third row is outside the limits";
}

}  // namespace
}  // namespace geom
