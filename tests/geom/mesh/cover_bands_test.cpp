#include "mesh/cover_bands.h"

#include <gtest/gtest.h>

#include "support/triangle_shapes.h"

namespace geom {
namespace {

CoverBands bands_of(const TriangleMesh& mesh, double slack) {
  const TriangleGroups groups = groups_by_part(mesh);
  TriangleCoverOptions options;
  options.slack = slack;
  return {mesh, groups, groups.groups.at(0), options, CoverGrid::of(slack, 100)};
}

TEST(CoverBands, AreOneWhereThereIsLittleToDo) {
  EXPECT_EQ(bands_of(support::cuboid({{0, 0, 0}, {10, 10, 10}}), 0.1).size(), 1u);
}

TEST(CoverBands, TogetherAreWhatOneWouldBe) {
  const TriangleMesh mesh = support::sphere({0, 0, 0}, 80, 30, 20);
  const CoverBands bands = bands_of(mesh, 0.2);
  ASSERT_GT(bands.size(), 3u);
  double top = -1e9;
  for (std::size_t k = 0; k < bands.size(); ++k) {
    const std::vector<Aabb> made = bands.boxes(mesh, k);
    ASSERT_FALSE(made.empty());
    const Aabb all = *bounds(made);
    EXPECT_TRUE(k == 0 || all.min.y() == top) << "neighbours share a side";
    top = all.max.y();
  }
}

TEST(JoinBands, MakesOneBoxOfOneThatGoesOnThroughAll) {
  std::vector<std::vector<Aabb>> bands = {{{{0, 0, 0}, {1, 2, 1}}, {{3, 0, 0}, {4, 2, 1}}},
                                          {{{0, 2, 0}, {1, 4, 1}}, {{3, 2, 0}, {4, 4, 2}}},
                                          {{{0, 4, 0}, {1, 5, 1}}}};
  join_bands(bands);
  EXPECT_EQ(bands[0][0], (Aabb{{0, 0, 0}, {1, 5, 1}}));
  EXPECT_EQ(bands[0].size(), 2u);
  ASSERT_EQ(bands[1].size(), 1u);
  EXPECT_EQ(bands[1][0], (Aabb{{3, 2, 0}, {4, 4, 2}})) << "another height";
  EXPECT_TRUE(bands[2].empty());
}

}  // namespace
}  // namespace geom
