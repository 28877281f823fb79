#include "geom/mesh/triangle_cover.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "support/reading.h"
#include "support/triangle_oracle.h"
#include "support/triangle_shapes.h"

namespace geom {
namespace {

using support::cuboid;
using support::Random;

TriangleCover cover(const TriangleMesh& mesh, double slack, SolidFill fill = SolidFill::none,
                    std::vector<double> down_to = {}, unsigned threads = 1) {
  TriangleCoverOptions options;
  options.slack = slack;
  options.fill = fill;
  options.down_to = std::move(down_to);
  return cover_triangles(mesh, options, {threads, {}});
}

template <class F>
void expect_refusal(const F& f, const std::string& message) {
  const std::string found = support::refusal_of(f);
  EXPECT_TRUE(support::says(found, message));
}

void expect_within(const oracle::Body& body, const TriangleCover& made, double slack) {
  for (const Aabb& box : made.boxes) {
    ASSERT_TRUE((box.min.array() <= box.max.array()).all());
    ASSERT_TRUE(oracle::within_slack(body, box, slack))
        << box.min.transpose() << " to " << box.max.transpose();
  }
}

TEST(TriangleCover, HoldsEveryPointOfATriangle) {
  constexpr std::size_t kPoints = 1000000;
  const TriangleMesh mesh = support::soup(1, 500);
  for (const double slack : {0.1, 0.5, 3.0}) {
    const TriangleCover made = cover(mesh, slack);
    const oracle::Holding holding(made.boxes);
    Random random(2);
    for (std::size_t i = 0; i < kPoints / 3 + 1; ++i) {
      const Vec3 p = support::exact_point(random, mesh, i % mesh.triangles.size());
      ASSERT_TRUE(holding(p)) << "slack " << slack << ", point " << i << ": " << p.transpose();
    }
  }
}

TEST(TriangleCover, HoldsEveryCorner) {
  const TriangleMesh mesh = support::soup(3, 300);
  for (const double slack : {0.03, 0.625, 1.6}) {  // cells of 0.39…, and of 1 m: on their sides
    const TriangleCover made = cover(mesh, slack);
    const oracle::Holding holding(made.boxes);
    for (const Vec3& v : mesh.vertices) ASSERT_TRUE(holding(v)) << v.transpose();
  }
}

TEST(TriangleCover, ReachesNoFurtherThanTheSlack) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    const TriangleMesh mesh = support::soup(seed, 12);
    for (const double slack : {0.3, 1.0, 1.6}) {
      expect_within(oracle::Body(mesh), cover(mesh, slack), slack);
    }
  }
}

TEST(TriangleCover, ReachesNoFurtherThanTheSlackFromWhatIsFilled) {
  const std::vector<TriangleMesh> meshes = {support::sphere({1, 2, 3}, 3, 9, 7),
                                            support::torus({0, 0, 0}, 4, 1.5, 10, 7)};
  for (const TriangleMesh& mesh : meshes) {
    oracle::Body body(mesh);
    body.fill();
    expect_within(body, cover(mesh, 0.5, SolidFill::inside), 0.5);
  }
}

TEST(TriangleCover, HoldsAllThatAClosedSurfaceEncloses) {
  const std::vector<TriangleMesh> meshes = {
      support::sphere({1, 2, 3}, 3, 9, 7), support::torus({0, 0, 0}, 4, 1.5, 10, 7),
      support::turned_inside_out(support::torus({0, 0, 0}, 4, 1.5, 10, 7)),
      cuboid({{-2, -1, 0}, {1, 1, 4}})};
  for (const TriangleMesh& mesh : meshes) {
    const oracle::Body body(mesh);
    const TriangleCover made = cover(mesh, 0.25, SolidFill::inside);
    EXPECT_EQ(made.closed, 1u);
    EXPECT_EQ(made.open, 0u);
    const oracle::Holding holding(made.boxes);
    Random random(4);
    std::size_t inside = 0;
    for (int i = 0; i < 20000; ++i) {
      const Vec3 p(random.uniform(-6, 6), random.uniform(-6, 6), random.uniform(-2, 7));
      if (std::abs(oracle::winding(p.cast<long double>(), body.triangles)) < 0.5L) continue;
      ++inside;
      ASSERT_TRUE(holding(p)) << p.transpose();
    }
    EXPECT_GT(inside, 300u);
  }
}

TEST(TriangleCover, LeavesTheHoleOfARingFree) {
  const TriangleCover made = cover(support::torus({0, 0, 0}, 4, 1, 24, 12), 0.3, SolidFill::inside);
  EXPECT_FALSE(oracle::Holding(made.boxes)({0, 0, 0}));
}

TEST(TriangleCover, OfAFilledCuboidIsTheCuboid) {
  const std::vector<Aabb> boxes = {{{0, 0, 0}, {1, 1, 1}},
                                   {{-3.3, 7.1, 2.2}, {100.7, 60.1, 90.9}},
                                   {{0.1, 0.2, 0.3}, {0.1001, 0.2001, 0.3001}}};
  for (const Aabb& box : boxes) {
    for (const double slack : {0.02, 0.8, 16.0}) {
      for (const bool out : {true, false}) {
        const TriangleMesh mesh = out ? cuboid(box) : support::turned_inside_out(cuboid(box));
        const TriangleCover made = cover(mesh, slack, SolidFill::inside);
        ASSERT_EQ(made.boxes.size(), 1u) << slack;
        EXPECT_EQ(made.boxes[0], box);
        EXPECT_EQ(made.closed, 1u);
      }
    }
  }
}

TEST(TriangleCover, OfTheShellOfACuboidIsAFewBoxes) {
  const TriangleCover made = cover(cuboid({{0.05, 0.05, 0}, {50.03, 30.01, 20}}), 0.2);
  EXPECT_LE(made.boxes.size(), 12u);
  EXPECT_FALSE(oracle::Holding(made.boxes)({25, 15, 10}));
}

TEST(TriangleCover, OfABigFlatRoofIsAFewBoxes) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 10}, {1000, 0, 10}, {1000, 700, 10}, {0, 700, 10}};
  support::add_quad(mesh, 0, 1, 2, 3);
  const TriangleCover flat = cover(mesh, 0.5);
  ASSERT_EQ(flat.boxes.size(), 1u);
  EXPECT_EQ(flat.boxes[0], (Aabb{{0, 0, 10}, {1000, 700, 10}}));
  const TriangleCover solid = cover(mesh, 0.5, SolidFill::down_to, {-1});
  ASSERT_EQ(solid.boxes.size(), 1u);
  EXPECT_EQ(solid.boxes[0], (Aabb{{0, 0, -1}, {1000, 700, 10}}));
}

TEST(TriangleCover, FillsARoofDownToTheHeightOfItsPart) {
  TriangleMesh mesh;  // two gables, the second's ground higher than its eaves
  for (const double x : {0.0, 20.0}) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const Vec3& v : {Vec3(0, 0, 3), Vec3(10, 0, 3), Vec3(10, 4, 7), Vec3(0, 4, 7),
                          Vec3(10, 8, 3), Vec3(0, 8, 3)}) {
      mesh.vertices.push_back(v + Vec3(x, 0, 0));
    }
    support::add_quad(mesh, first, first + 1, first + 2, first + 3, x > 0);
    support::add_quad(mesh, first + 3, first + 2, first + 4, first + 5, x > 0);
  }
  const double slack = 0.4;
  const TriangleCover made = cover(mesh, slack, SolidFill::down_to, {-2, 4});
  std::set<std::uint32_t> parts(made.part.begin(), made.part.end());
  EXPECT_EQ(parts, (std::set<std::uint32_t>{0, 1}));
  oracle::Body body(mesh);
  const auto roof = [](long double y) { return 7 - std::abs(y - 4); };
  body.solid = [&](const oracle::Wide& p) {
    if (p.y() < 0 || p.y() > 8) return false;
    const bool first = p.x() >= 0 && p.x() <= 10;
    if (!first && (p.x() < 20 || p.x() > 30)) return false;
    const long double ground = first ? -2 : 4;
    return p.z() >= std::min(ground, roof(p.y())) && p.z() <= std::max(ground, roof(p.y()));
  };
  expect_within(body, made, slack);
  const oracle::Holding holding(made.boxes);
  Random random(9);
  for (int i = 0; i < 50000; ++i) {
    const Vec3 p(random.uniform(0, 30), random.uniform(0, 8), random.uniform(-2, 7));
    if (!body.solid(p.cast<long double>())) continue;
    ASSERT_TRUE(holding(p)) << p.transpose();
  }
}

TEST(TriangleCover, CountsSurfacesThatAreNotClosedAndKeepsTheirShell) {
  TriangleMesh mesh = cuboid({{0, 0, 0}, {4, 4, 4}});
  mesh.triangles.pop_back();  // a hole
  support::add(mesh, cuboid({{10, 0, 0}, {14, 4, 4}}));
  TriangleMesh flipped = cuboid({{20, 0, 0}, {24, 4, 4}});
  std::swap(flipped.triangles[3].corners[0], flipped.triangles[3].corners[1]);
  support::add(mesh, flipped);
  const TriangleCover made = cover(mesh, 0.2, SolidFill::inside);
  EXPECT_EQ(made.closed, 1u);
  EXPECT_EQ(made.open, 2u);
  const oracle::Holding holding(made.boxes);
  EXPECT_FALSE(holding({2, 2, 2}));
  EXPECT_TRUE(holding({12, 2, 2}));
  EXPECT_FALSE(holding({22, 2, 2}));
  for (const Vec3& v : mesh.vertices) EXPECT_TRUE(holding(v));
}

// One surface that runs into another leaves no place of either free, whichever way they face.
TEST(TriangleCover, FillsSurfacesThatCrossEachOther) {
  TriangleMesh mesh = cuboid({{0, 0, 0}, {4, 4, 4}});
  support::add(mesh, support::turned_inside_out(cuboid({{2, 1, 1}, {6, 3, 3}})));
  support::add(mesh, cuboid({{1, 1, 1}, {2, 2, 2}}));
  const TriangleCover made = cover(mesh, 0.3, SolidFill::inside);
  EXPECT_EQ(made.closed, 3u);
  const oracle::Holding holding(made.boxes);
  for (const Vec3& p : {Vec3(3, 2, 2), Vec3(1.5, 1.5, 1.5), Vec3(5, 2, 2)}) EXPECT_TRUE(holding(p));
}

TEST(TriangleCover, HasTheSameBoxesForAnyNumberOfThreads) {
  TriangleMesh mesh = support::soup(7, 1000);
  support::add(mesh, support::sphere({0, 0, 30}, 20, 60, 40), 1);
  for (const SolidFill fill : {SolidFill::none, SolidFill::inside, SolidFill::down_to}) {
    const TriangleCover one = cover(mesh, 0.2, fill, {-9, 0, 4}, 1);
    for (const unsigned threads : {2u, 7u}) {
      const TriangleCover many = cover(mesh, 0.2, fill, {-9, 0, 4}, threads);
      EXPECT_EQ(one.boxes, many.boxes);
      EXPECT_EQ(one.part, many.part);
    }
  }
}

TEST(TriangleCover, IsExactFarFromTheOrigin) {
  TriangleMesh mesh = support::soup(5, 200);
  for (Vec3& v : mesh.vertices) v += Vec3(9e7, -9.9e7, 1e4);
  const double slack = 0.2;
  const TriangleCover made = cover(mesh, slack);
  const oracle::Holding holding(made.boxes);
  for (const Vec3& v : mesh.vertices) ASSERT_TRUE(holding(v));
  const TriangleMesh few = {{mesh.vertices.begin(), mesh.vertices.begin() + 18},
                            {mesh.triangles.begin(), mesh.triangles.begin() + 6}};
  expect_within(oracle::Body(few), cover(few, slack), slack);
}

TEST(TriangleCover, OfNothingIsNothing) { EXPECT_TRUE(cover({}, 1).boxes.empty()); }

TEST(TriangleCover, RefusesWhatIsNoTriangle) {
  const TriangleMesh good = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{{0, 1, 2}, 0}}};
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1.1e8}) {
    for (int axis = 0; axis < 3; ++axis) {
      TriangleMesh mesh = good;
      mesh.vertices[2][axis] = bad;
      expect_refusal([&] { cover(mesh, 1); }, "triangle 0: expected coordinates within");
    }
  }
  TriangleMesh index = good;
  index.triangles[0].corners[1] = 3;
  expect_refusal([&] { cover(index, 1); }, "triangle 0: expected vertices below 3, found 3");
}

TEST(TriangleCover, RefusesASlackThatMeansNothing) {
  const TriangleMesh mesh = {{{5e7, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{{0, 1, 2}, 0}}};
  for (const double bad : {0.0, -1.0, 0.04, std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity()}) {
    expect_refusal([&] { cover(mesh, bad); }, "expected a slack from 0.05 m");
  }
}

TEST(TriangleCover, RefusesAPartWithoutAHeightToFillDownTo) {
  const TriangleMesh mesh = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{{0, 1, 2}, 1}}};
  expect_refusal([&] { cover(mesh, 1, SolidFill::down_to, {0}); }, "part 1");
  expect_refusal(
      [&] {
        cover(mesh, 1, SolidFill::down_to, {0, std::numeric_limits<double>::quiet_NaN()});
      },
      "part 1");
}

TEST(TriangleCover, RefusesBeforeItCutsIntoTooManyPiecesAndNamesASlackThatWouldDo) {
  const TriangleMesh mesh = {{{0, 0, 0}, {1e6, 0, 1e6}, {0, 1e6, 5e5}}, {{{0, 1, 2}, 0}}};
  expect_refusal([&] { cover(mesh, 0.1); },
                 "1 triangles would be cut into up to 1.3e+14 pieces for a slack of 0.1");
  expect_refusal([&] { cover(mesh, 0.1); }, "a slack of 102.4 m would do");
}

}  // namespace
}  // namespace geom
