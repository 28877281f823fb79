#include "geom/mesh/mesh.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstring>
#include <sstream>

#include "support/random_city.h"

namespace geom {
namespace {

// Six times the volume that the triangles from `first` on enclose, seen from `middle`.
double enclosed(const MeshPart& part, std::size_t first, std::size_t end, const Vec3& middle) {
  double sum = 0;
  for (std::size_t i = first; i < end; ++i) {
    const auto [a, b, c] = part.triangle(i);
    sum += (part.vertex(a) - middle).dot((part.vertex(b) - middle).cross(part.vertex(c) - middle));
  }
  return sum / 6;
}

TEST(RodPart, SpheresAreClosedAndFaceOutward) {
  const MeshPart part = rod_part({"s", {}, {{5, 6, 7}}, {}, 0.25, 2});
  EXPECT_EQ(part.vertices, 66u);
  EXPECT_EQ(part.triangles, 128u);
  const double ball = 4.0 / 3 * 3.141592653589793 * 8;
  EXPECT_NEAR(enclosed(part, 0, part.triangles, {0, 0, 0}), ball, 0.1 * ball);
  for (std::size_t i = 0; i < part.vertices; ++i) {
    EXPECT_NEAR((part.vertex(i) - Vec3(5, 6, 7)).norm(), 2, 1e-12);
  }
}

TEST(RodPart, CylindersFaceOutwardInEveryDirection) {
  support::Random random(41);
  for (int round = 0; round < 50; ++round) {
    const auto any = [&] {
      return Vec3(random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9));
    };
    const Vec3 a = any();
    const Vec3 b = round == 0 ? Vec3(a + Vec3(0, 0, 3)) : any();
    const MeshPart part = rod_part({"r", {}, {a, b}, {{0, 1}}, 0.5, 0.1});
    const std::size_t first = 2 * 128;
    ASSERT_EQ(part.triangles, first + 16);
    // Open at its ends, which a point on the axis sees edge on from the middle of neither.
    const double prism = 0.5 * 8 * 0.25 * std::sin(3.141592653589793 / 4) * (b - a).norm();
    EXPECT_NEAR(enclosed(part, first, part.triangles, 0.5 * (a + b)), prism * 2 / 3, 1e-9)
        << "seed 41, round " << round;
  }
}

TEST(RodPart, ARodOfNoLengthIsFinite) {
  const MeshPart part = rod_part({"r", {}, {{1, 1, 1}, {1, 1, 1}}, {{0, 1}}, 0.5, 0.5});
  for (std::size_t i = 0; i < part.vertices; ++i) EXPECT_TRUE(part.vertex(i).allFinite());
}

TEST(PolytopePart, FacesOutwardInEveryAxes) {
  std::vector<Plane> planes;
  for (int axis = 0; axis < 3; ++axis) {
    planes.push_back({Vec3::Unit(axis), 5.0 + axis});
    planes.push_back({-Vec3::Unit(axis), -3.0});
  }
  planes.push_back({Vec3(1, 1, 1), 17});  // cuts the corner (5, 6, 7) off
  const Polytope regions[] = {polytope(planes), polytope(planes)};
  const double whole = 2.0 * 3 * 4;
  for (const Axes axes : {Axes::enu, Axes::neu}) {
    const MeshPart part = polytope_part("c", {}, axes, regions);
    ASSERT_EQ(part.triangles % 2, 0u);
    for (std::size_t k = 0; k < 2; ++k) {
      const std::size_t first = k * part.triangles / 2;
      EXPECT_NEAR(enclosed(part, first, first + part.triangles / 2, {9, 9, 9}), whole - 1.0 / 6,
                  1e-9);
    }
    EXPECT_EQ(part.vertex(0), to_enu(axes, regions[0].vertices[0]));
  }
}

TEST(PolytopePart, IsHalfTransparentWhereAsked) {
  MeshPart part = rod_part({"s", {}, {{0, 0, 0}}, {}, 1, 1});
  std::ostringstream solid;
  write_glb(solid, std::span(&part, 1));
  EXPECT_EQ(solid.str().find("BLEND"), std::string::npos);
  part.opacity = 0.25;
  std::ostringstream clear;
  write_glb(clear, std::span(&part, 1));
  EXPECT_NE(clear.str().find(",0.25],"), std::string::npos);
  EXPECT_NE(clear.str().find(R"("alphaMode":"BLEND")"), std::string::npos);
}

TEST(WriteGlb, OfNothingIsAnEmptyScene) {
  std::ostringstream out;
  write_glb(out, {});
  EXPECT_NE(out.str().find(R"("scenes":[{}])"), std::string::npos);
  EXPECT_EQ(out.str().find("nan"), std::string::npos);
}

TEST(WritePly, IndicesOfLaterPartsCountOn) {
  const BoxMap map = support::random_city(3, 2, 40);
  std::vector<MeshPart> parts = box_parts(map);
  parts.push_back(rod_part({"s", {}, {{0, 0, 0}}, {}, 1, 1}));
  std::ostringstream out;
  write_ply(out, parts);
  const std::string text = out.str();
  EXPECT_NE(text.find("element vertex 90\n"), std::string::npos);
  std::int32_t last = 0;
  std::memcpy(&last, text.data() + text.size() - 4, 4);
  EXPECT_GE(last, 24);
  EXPECT_LT(last, 90);
}

}  // namespace
}  // namespace geom
