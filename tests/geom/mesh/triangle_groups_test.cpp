#include "mesh/triangle_groups.h"

#include <gtest/gtest.h>

#include "support/triangle_shapes.h"

namespace geom {
namespace {

const Aabb kUnit{{0, 0, 0}, {1, 1, 1}};

std::size_t closed(const TriangleGroups& groups) {
  std::size_t n = 0;
  for (const TriangleGroup& g : groups.groups) n += g.closed;
  return n;
}

TEST(TriangleGroups, ByPartAreThePartsInTheOrderTheyAppear) {
  TriangleMesh mesh;
  support::add(mesh, support::cuboid(kUnit), 5);
  support::add(mesh, support::cuboid(kUnit), 2);
  mesh.triangles.push_back({{0, 1, 2}, 5});
  const TriangleGroups groups = groups_by_part(mesh);
  ASSERT_EQ(groups.groups.size(), 2u);
  EXPECT_EQ(groups.groups[0].part, 5u);
  EXPECT_EQ(groups.groups[0].count, 13u);
  EXPECT_EQ(groups.triangles[12], 24u);
  EXPECT_EQ(groups.groups[1].first, 13u);
  EXPECT_EQ(closed(groups), 0u);
}

TEST(TriangleGroups, BySurfaceJoinVerticesOfEqualCoordinates) {
  TriangleMesh mesh;  // no vertex shared, as in STL; some zeros negative
  const TriangleMesh cube = support::cuboid(kUnit);
  for (const MeshTriangle& t : cube.triangles) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const std::uint32_t i : t.corners) {
      mesh.vertices.push_back(first % 2 ? Vec3(-0.0 + cube.vertices[i].array()) : cube.vertices[i]);
    }
    if (first % 2)
      mesh.vertices[first] =
          mesh.vertices[first].unaryExpr([](double v) { return v == 0 ? -0.0 : v; });
    mesh.triangles.push_back({{first, first + 1, first + 2}, 0});
  }
  const TriangleGroups groups = groups_by_surface(mesh);
  ASSERT_EQ(groups.groups.size(), 1u);
  EXPECT_TRUE(groups.groups[0].closed);
  EXPECT_EQ(groups.open_surfaces, 0u);
}

TEST(TriangleGroups, BySurfaceTellOpenFromClosed) {
  TriangleMesh mesh = support::cuboid(kUnit);                 // closed
  support::add(mesh, support::torus({5, 5, 5}, 2, 1, 8, 5));  // closed
  TriangleMesh holed = support::cuboid({{9, 9, 9}, {10, 10, 10}});
  holed.triangles.erase(holed.triangles.begin() + 4);
  support::add(mesh, holed);  // open
  mesh.vertices.insert(mesh.vertices.end(), {{50, 0, 0}, {51, 0, 0}, {50, 1, 0}});
  const auto n = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.triangles.push_back({{n - 3, n - 2, n - 1}, 0});  // two sides, nothing inside
  mesh.triangles.push_back({{n - 3, n - 1, n - 2}, 0});
  mesh.triangles.push_back({{n - 1, n - 1, n - 1}, 0});  // a point
  const TriangleGroups groups = groups_by_surface(mesh);
  EXPECT_EQ(closed(groups), 2u);
  EXPECT_EQ(groups.open_surfaces, 3u);
  ASSERT_EQ(groups.groups.size(), 3u) << "all that is open is one group";
  EXPECT_EQ(groups.groups[2].count, 11u + 3u);
  EXPECT_FALSE(groups.groups[2].closed);
}

TEST(TriangleGroups, SurfacesOfTwoPartsAreTwo) {
  TriangleMesh mesh = support::cuboid(kUnit);
  for (std::size_t t = 0; t < 6; ++t) mesh.triangles[t].part = 1;
  const TriangleGroups groups = groups_by_surface(mesh);
  EXPECT_EQ(closed(groups), 0u);
  EXPECT_EQ(groups.groups.size(), 2u);
}

TEST(TriangleGroups, ASurfaceOfWhichOneTriangleFacesTheOtherWayIsOpen) {
  TriangleMesh mesh = support::cuboid(kUnit);
  std::swap(mesh.triangles[3].corners[0], mesh.triangles[3].corners[1]);
  EXPECT_EQ(closed(groups_by_surface(mesh)), 0u);
  EXPECT_EQ(closed(groups_by_surface(support::turned_inside_out(support::cuboid(kUnit)))), 1u);
}

}  // namespace
}  // namespace geom
