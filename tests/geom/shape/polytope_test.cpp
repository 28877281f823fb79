#include "geom/shape/polytope.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "support/random_city.h"

namespace geom {
namespace {

std::vector<Plane> faces_of(const Aabb& box) {
  std::vector<Plane> planes;
  for (int i = 0; i < 3; ++i) {
    planes.push_back({Vec3::Unit(i), box.max[i]});
    planes.push_back({-Vec3::Unit(i), -box.min[i]});
  }
  return planes;
}

// By the divergence theorem: only right when all faces are there and turn the right way.
double volume(const Polytope& p) {
  double six = 0;
  for (const auto& face : p.faces) {
    for (std::size_t i = 1; i + 1 < face.size(); ++i) {
      six += p.vertices[face[0]].dot(p.vertices[face[i]].cross(p.vertices[face[i + 1]]));
    }
  }
  return six / 6;
}

TEST(Polytope, OfABoxIsTheBox) {
  const Polytope p = polytope(faces_of({{1, 2, 3}, {4, 6, 8}}));
  EXPECT_EQ(p.vertices.size(), 8u);
  ASSERT_EQ(p.faces.size(), 6u);
  for (const auto& face : p.faces) EXPECT_EQ(face.size(), 4u);
  EXPECT_DOUBLE_EQ(volume(p), 60);
}

TEST(Polytope, LosesACornerToAPlane) {
  auto planes = faces_of({{0, 0, 0}, {2, 2, 2}});
  planes.push_back({Vec3(1, 1, 1), 5});
  const Polytope p = polytope(planes);
  EXPECT_EQ(p.vertices.size(), 10u);
  EXPECT_EQ(p.faces.size(), 7u);
  EXPECT_NEAR(volume(p), 8 - 1.0 / 6, 1e-12);
}

// Four planes through one corner, a plane twice, and one that only touches an edge.
TEST(Polytope, TakesPlanesThatMeetInFours) {
  auto planes = faces_of({{0, 0, 0}, {2, 2, 2}});
  planes.push_back({Vec3(1, 1, 1), 6});
  planes.push_back({Vec3(2, 0, 0), 4});
  planes.push_back({Vec3(1, 1, 0), 4});
  const Polytope p = polytope(planes);
  EXPECT_EQ(p.vertices.size(), 8u);
  EXPECT_EQ(p.faces.size(), 6u);
  EXPECT_DOUBLE_EQ(volume(p), 8);
}

TEST(Polytope, OfNothingOrAFlatRegionHasNoFaces) {
  auto planes = faces_of({{0, 0, 0}, {1, 1, 1}});
  planes.push_back({-Vec3::UnitX(), -2});
  EXPECT_TRUE(polytope(planes).vertices.empty());
  EXPECT_TRUE(polytope(faces_of({{0, 0, 0}, {1, 1, 0}})).faces.empty());
}

// Each cut halves the region; the two halves make the whole, and no vertex is outside.
TEST(Polytope, IsCutInTwoPartsThatMakeTheWhole) {
  support::Random random(1);
  for (int n = 0; n < 50; ++n) {
    auto planes = faces_of({{-1, -1, -1}, {1, 1, 1}});
    for (int i = 0; i < 6; ++i) {
      Vec3 normal(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
      if (n % 2) normal = {random.stepped(-1, 1, 0.5), random.stepped(-1, 1, 0.5), 1};
      const Plane cut{normal, random.stepped(0, 0.5, 0.125)};
      auto other = planes;
      const double whole = volume(polytope(planes));
      planes.push_back(cut);
      other.push_back({-cut.normal, -cut.offset});
      EXPECT_NEAR(volume(polytope(planes)) + volume(polytope(other)), whole, 1e-9) << n;
    }
    for (const Vec3& v : polytope(planes).vertices) {
      for (const Plane& plane : planes) EXPECT_LE(plane.normal.dot(v), plane.offset + 1e-12);
    }
  }
}

}  // namespace
}  // namespace geom
