#include "geom/model/model_polygons.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace geom {
namespace {

Model model_of(const std::vector<Vec3>& corners) {
  Model model;
  model.parts = {"a", "wall"};
  model.mesh.vertices = corners;
  std::vector<std::uint32_t> all(corners.size());
  std::iota(all.begin(), all.end(), 0u);
  ModelPolygons polygons;
  polygons.add(model, all, 1);
  polygons.finish(model);
  return model;
}

bool holds(const Model& model, const Vec3& p) {
  TriangleCoverOptions options;
  options.slack = 0.01;
  const TriangleCover made = cover_model(model, options);
  return std::any_of(made.boxes.begin(), made.boxes.end(),
                     [&](const Aabb& box) { return contains(box, p); });
}

TEST(ModelPolygons, AFlatOneIsItsTrianglesAlone) {
  const Model model = model_of({{0, 0, 0}, {4, 0, 4}, {4, 4, 4}, {0, 4, 0}});
  EXPECT_EQ(model.mesh.triangles.size(), 2u);
  EXPECT_EQ(model.bent, 0u);
  EXPECT_EQ(model.parts.size(), 2u);
}

// One diagonal lies on the ground, the other at 2 m.
TEST(ModelPolygons, ABentQuadrangleIsAllBetweenItsDiagonals) {
  const Model model = model_of({{0, 0, 0}, {4, 0, 2}, {4, 4, 0}, {0, 4, 2}});
  EXPECT_EQ(model.bent, 1u);
  EXPECT_EQ(model.parts, (std::vector<std::string>{"a", "wall", "wall"}));
  EXPECT_TRUE(holds(model, {2, 2, 0}));
  EXPECT_TRUE(holds(model, {2, 2, 2}));
  EXPECT_TRUE(holds(model, {2, 2, 1}));
  EXPECT_FALSE(holds(model, {2, 0.5, 0.1}));
}

TEST(ModelPolygons, ABentPentagonIsAllBetweenItsHeights) {
  const std::vector<Vec3> corners = {{0, 0, 0}, {4, 0, 1}, {5, 3, 0}, {2, 5, 1}, {-1, 3, 0}};
  const Model model = model_of(corners);
  EXPECT_EQ(model.bent, 1u);
  for (std::size_t i = 0; i < 5; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      for (std::size_t k = 0; k < j; ++k) {
        EXPECT_TRUE(holds(model, (corners[i] + corners[j] + corners[k]) / 3)) << i << j << k;
      }
    }
  }
}

// From the side it has no notch, and there programs cut it.
TEST(ModelPolygons, ACrookedPentagonIsHeldWithItsNotch) {
  const std::vector<Vec3> corners = {{0, 0, 0}, {4, 0, 1}, {5, 3, 0}, {2, 2.9, 1}, {-1, 3, 0}};
  EXPECT_TRUE(holds(model_of(corners), (corners[2] + corners[4]) / 2));
}

TEST(ModelPolygons, ANotchStaysFreeWhereThePolygonIsBentALittle) {
  const Model model = model_of({{0, 0, 0}, {4, 0, 0.01}, {1, 1, 0}, {0, 4, 0.02}});
  EXPECT_FALSE(holds(model, {1.9, 1.9, 0.01}));
  const Model more = model_of({{0, 0, 0}, {4, 0, 0.01}, {4, 4, 0}, {2, 1, 0.02}, {0, 4, 0}});
  EXPECT_EQ(more.bent, 1u);
  EXPECT_FALSE(holds(more, {2, 3.5, 0.01}));
}

// A closed body with one bent side: both ways to cut that are inside.
TEST(ModelPolygons, ABodyIsClosedAndHoldsBothWays) {
  Model model;
  model.parts = {"a"};
  model.mesh.vertices = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0},
                         {0, 0, 4}, {4, 0, 6}, {4, 4, 4}, {0, 4, 6}};
  ModelPolygons polygons;
  for (const std::array<std::uint32_t, 4>& side : {std::array<std::uint32_t, 4>{0, 3, 2, 1},
                                                   {4, 5, 6, 7},
                                                   {0, 1, 5, 4},
                                                   {1, 2, 6, 5},
                                                   {2, 3, 7, 6},
                                                   {3, 0, 4, 7}}) {
    polygons.add(model, side, 0);
  }
  polygons.finish(model);
  EXPECT_EQ(model.bent, 1u);
  TriangleCoverOptions options;
  options.slack = 0.05;
  options.fill = SolidFill::inside;
  const TriangleCover made = cover_model(model, options);
  EXPECT_EQ(made.open, 0u);
  for (const Vec3& p : {Vec3(2, 2, 2), Vec3(2, 2, 4.1), Vec3(2, 2, 5.9)}) {
    EXPECT_TRUE(std::any_of(made.boxes.begin(), made.boxes.end(), [&](const Aabb& box) {
      return contains(box, p);
    })) << p.transpose();
  }
}

}  // namespace
}  // namespace geom
