#include "map/plane_fit.h"

#include <gtest/gtest.h>

namespace geom {
namespace {

TEST(PlaneFit, GoesThroughCornersThatLieInOne) {
  const PlaneFit plane = fit_plane({{0, 0, 1}, {4, 0, 3}, {4, 6, 6}, {0, 6, 4}});
  EXPECT_NEAR(plane.gradient.x(), 0.5, 1e-12);
  EXPECT_NEAR(plane.gradient.y(), 0.5, 1e-12);
  EXPECT_NEAR(plane({2, 2}), 3, 1e-12);
  EXPECT_LT(plane.residual, 1e-8);
  EXPECT_EQ(plane.low, 1);
  EXPECT_EQ(plane.high, 6);
  EXPECT_NEAR(plane.thickness(), 4, 1e-9);
  EXPECT_FALSE(is_upright(plane, 0.5));
}

TEST(PlaneFit, SaysHowFarCornersLieFromIt) {
  const std::vector<Vec3> warped = {{0, 0, 0}, {2, 0, 1}, {2, 2, 0}, {0, 2, 1}};
  const PlaneFit plane = fit_plane(warped);
  for (const Vec3& p : warped) {
    EXPECT_LE(std::abs(p.z() - plane(p.head<2>())), plane.residual);
  }
  EXPECT_NEAR(plane.residual, 0.5, 1e-6);
}

TEST(PlaneFit, KnowsAWall) {
  const PlaneFit wall = fit_plane({{0, 0, 0}, {3, 4, 0}, {3, 4, 9}, {0, 0, 9}});
  EXPECT_TRUE(is_upright(wall, 0.01));
  EXPECT_LT(wall.thickness(), 1e-9);
  EXPECT_NEAR(std::abs(wall.along.dot(Vec2(0.6, 0.8))), 1, 1e-12);
  const PlaneFit pole = fit_plane({{1, 1, 0}, {1, 1, 5}});
  EXPECT_TRUE(is_upright(pole, 0.01));
}

TEST(CornersOf, TakesOneHeightForEachCornerOfAllRings) {
  Footprint f;
  f.polygon = {{{0, 0}, {9, 0}, {9, 9}}, {{{5, 2}, {6, 2}, {6, 3}}}};
  f.top = 7;
  EXPECT_EQ(corners_of(f)[4], Vec3(6, 2, 7));
  f.heights = {1, 2, 3, 4, 5, 6};
  EXPECT_EQ(corners_of(f)[4], Vec3(6, 2, 5));
}

}  // namespace
}  // namespace geom
