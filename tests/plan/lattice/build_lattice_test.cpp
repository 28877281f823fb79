#include "plan/lattice/build_lattice.h"

#include <gtest/gtest.h>

#include <set>

#include "geom/base/error.h"
#include "plan/scenes.h"
#include "support/exact_oracle.h"

namespace plan {
namespace {

const geom::Aabb kCube{{0, 0, 0}, {10, 10, 10}};

bool exactly_free(const geom::CollisionScene& scene, const Vec3& a, const Vec3& b) {
  for (std::size_t i = 0; i < scene.map().size(); ++i) {
    if (oracle::segment_hits(a, b, scene.grown(i))) return false;
  }
  return true;
}

int expected_axes(Connectivity connectivity) {
  return connectivity == Connectivity::six ? 1 : connectivity == Connectivity::eighteen ? 2 : 3;
}

// Every node and every direction against exact rational arithmetic.
void expect_exact(const geom::CollisionScene& scene, const Lattice& lattice) {
  for (std::size_t n = 0; n < lattice.size(); ++n) {
    const Vec3 p = lattice.position(n);
    ASSERT_EQ(lattice.free(n), exactly_free(scene, p, p)) << p.transpose();
    for (int d = 0; d < kDirections; ++d) {
      Index3 to = lattice.index(n);
      int axes = 0;
      for (int k = 0; k < 3; ++k) {
        to[k] += kDirection[d][k];
        axes += kDirection[d][k] != 0;
      }
      const auto next = lattice.node(to);
      const bool expected = next && axes <= expected_axes(lattice.spec().connectivity) &&
                            exactly_free(scene, p, lattice.position(*next));
      ASSERT_EQ((lattice.mask(n) >> d & 1) != 0, expected) << p.transpose() << " direction " << d;
    }
  }
}

TEST(LatticeDirections, AreThe26AndEachIsFollowedBy13ByItsOpposite) {
  std::set<std::array<int, 3>> seen(kDirection.begin(), kDirection.end());
  EXPECT_EQ(seen.size(), 26u);
  EXPECT_FALSE(seen.contains({0, 0, 0}));
  for (int d = 0; d < kHalfDirections; ++d) {
    for (int k = 0; k < 3; ++k) EXPECT_EQ(kDirection[d][k], -kDirection[d + kHalfDirections][k]);
    const int axes =
        std::abs(kDirection[d][0]) + std::abs(kDirection[d][1]) + std::abs(kDirection[d][2]);
    EXPECT_EQ(axes, d < 3 ? 1 : d < 9 ? 2 : 3);
  }
}

TEST(BuildLattice, NodesCoverTheClosedFreeBounds) {
  const auto scene = scene_of({}, kCube, {1, 1, 1});
  const Lattice lattice = build_lattice(scene, {2, Connectivity::six, {1, 1, 0}});
  EXPECT_EQ(lattice.dims(), (Index3{5, 5, 4}));  // 1 … 9 in x and y, 2 … 8 in z
  EXPECT_EQ(lattice.first(), (Index3{0, 0, 1}));
  EXPECT_EQ(lattice.position(0), Vec3(1, 1, 2));
  EXPECT_EQ(lattice.counts().nodes, 100u);
  EXPECT_EQ(lattice.counts().edges, 4 * 5 * 4 + 5 * 4 * 4 + 5 * 5 * 3u);
}

TEST(BuildLattice, OriginMayLieAnywhere) {
  const auto scene = scene_of({}, kCube);
  const Lattice lattice = build_lattice(scene, {3, Connectivity::six, {-100, 50, 1000.5}});
  EXPECT_EQ(lattice.position(0), Vec3(2, 2, 1.5));
  EXPECT_EQ(lattice.coordinate(0, 0), -100 + 34 * 3.0);
  EXPECT_EQ(lattice.first(), (Index3{34, -16, -333}));
}

TEST(BuildLattice, TouchingAFaceBlocksNodesAndEdges) {
  const auto scene = scene_of({{{4, 4, 4}, {6, 6, 6}}}, kCube);
  const double just_before = scene.grown(0).min.x();
  const Lattice touching = build_lattice(scene, {1, Connectivity::six, {just_before, 5, 5}});
  EXPECT_FALSE(touching.free(touching.node({-touching.first()[0], 5, 5}).value()));
  const double beside = std::nextafter(just_before, 0.0);
  const Lattice clear = build_lattice(scene, {4, Connectivity::six, {beside, 5, 5}});
  EXPECT_TRUE(clear.free(clear.node({-clear.first()[0], 1, 1}).value()));
}

TEST(BuildLattice, BoxesBetweenNodesBlockOnlyEdges) {
  const auto scene = scene_of({{{4.4, 3.9, 3.9}, {4.6, 4.1, 4.1}}}, kCube);
  const Lattice lattice = build_lattice(scene, {1, Connectivity::six, {0, 0, 0}});
  EXPECT_EQ(lattice.counts().nodes, 11 * 11 * 11u);
  EXPECT_EQ(lattice.counts().edges, 3 * 10 * 11 * 11 - 1u);
  EXPECT_FALSE(lattice.mask(lattice.node({4, 4, 4}).value()) & 1);
}

TEST(BuildLattice, AgreesWithExactArithmeticOnEveryNodeAndEdge) {
  constexpr Connectivity kAll[] = {Connectivity::six, Connectivity::eighteen,
                                   Connectivity::twenty_six};
  for (std::uint64_t seed = 0; seed < 18; ++seed) {
    SCOPED_TRACE(seed);
    const Vec3 half = Vec3::Constant(seed % 2 ? 0.0 : 0.5);
    const auto scene = random_scene(seed, 6, 8, half);
    const Vec3 origin = seed % 3 ? Vec3(0, 0, 0) : Vec3(0.3, -20.7, 1e3 + 0.1);
    expect_exact(scene, build_lattice(scene, {1.0, kAll[seed % 3], origin}));
  }
}

// Faces of grown boxes reach a slack beyond whole metres: put the nodes on those faces instead.
TEST(BuildLattice, AgreesWithExactArithmeticWhereFacesTouchNodesExactly) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    SCOPED_TRACE(seed);
    support::Random random(seed);
    auto scene = scene_of(random_boxes(random, 5, 6), {{0, 0, 0}, {6, 6, 6}});
    const geom::Aabb face = scene.grown(seed % 5);
    for (const double spacing : {1.0, face.max.x() - face.min.x() + 1}) {
      expect_exact(scene, build_lattice(scene, {spacing, Connectivity::twenty_six, face.min}));
    }
  }
}

TEST(BuildLattice, AgreesWithTheCollisionSceneOnManyThreads) {
  const auto scene = random_scene(7, 60, 20, {0.4, 0.4, 0.2});
  const LatticeSpec spec{1, Connectivity::twenty_six, {0.1, 0.2, 0.3}};
  const Lattice lattice = build_lattice(scene, spec, {7, {}});
  for (std::size_t n = 0; n < lattice.size(); ++n) {
    const Vec3 p = lattice.position(n);
    ASSERT_EQ(lattice.free(n), scene.free(p));
    for (int d = 0; d < kDirections; ++d) {
      Index3 to = lattice.index(n);
      for (int k = 0; k < 3; ++k) to[k] += kDirection[d][k];
      const auto next = lattice.node(to);
      if (!next) continue;
      ASSERT_EQ((lattice.mask(n) >> d & 1) != 0, scene.free(p, lattice.position(*next)));
    }
  }
}

TEST(BuildLattice, RefusesWhatHasNoNodesOrTooMany) {
  const auto scene = scene_of({}, kCube, {1, 1, 1});
  EXPECT_THROW(build_lattice(scene, {100, Connectivity::six, {-1, 0, 0}}), geom::InputError);
  EXPECT_THROW(build_lattice(scene, {1e-4, Connectivity::six, {0, 0, 0}}), geom::InputError);
  EXPECT_THROW(build_lattice(scene, {1e-300, Connectivity::six, {0, 0, 0}}), geom::InputError);
  EXPECT_THROW(build_lattice(scene, {1e-16, Connectivity::six, {1e3, 0, 0}}), geom::InputError);
  const auto tight = scene_of({}, kCube, {6, 1, 1});
  EXPECT_THROW(build_lattice(tight, {1, Connectivity::six, {0, 0, 0}}), geom::InputError);
}

TEST(Lattice, IndexAndNodeAreInverse) {
  const auto scene = scene_of({}, {{0, 0, 0}, {4, 3, 2}});
  const Lattice lattice = build_lattice(scene, {1, Connectivity::six, {0, 0, 0}});
  for (std::size_t n = 0; n < lattice.size(); ++n) EXPECT_EQ(lattice.node(lattice.index(n)), n);
  EXPECT_EQ(lattice.node({5, 0, 0}), std::nullopt);
  EXPECT_EQ(lattice.node({0, -1, 0}), std::nullopt);
  EXPECT_EQ(lattice.index(1), (Index3{1, 0, 0}));  // x fastest
  EXPECT_EQ(lattice.offset(2), 5 * 4);
}

}  // namespace
}  // namespace plan
