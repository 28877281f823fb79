#include "plan/lattice/lattice.h"

#include <gtest/gtest.h>

#include <sstream>

#include "plan/lattice/build_lattice.h"
#include "plan/lattice/lattice_file.h"
#include "support/exact_oracle.h"
#include "support/random_city.h"

namespace plan {
namespace {

using geom::CollisionScene;

bool blocked(const CollisionScene& scene, const Vec3& a, const Vec3& b) {
  for (std::size_t i = 0; i < scene.map().size(); ++i) {
    const geom::Aabb box = scene.grown(i);
    if (geom::overlap(box, {a.cwiseMin(b), a.cwiseMax(b)}) && oracle::segment_hits(a, b, box)) {
      return true;
    }
  }
  return false;
}

struct Case {
  Connectivity connectivity;
  double spacing;
  Vec3 half;
};

class LatticeProperty : public testing::TestWithParam<Case> {};

// Boxes stand on whole metres and the vehicle has whole or half sizes, so nodes and edges often
// touch faces, edges and corners exactly.
TEST_P(LatticeProperty, EveryNodeAndEdgeAgreesWithRationals) {
  const Case& c = GetParam();
  const CollisionScene scene(support::random_city(21, 60, 80), {"box", c.half}, 0);
  const Lattice lattice =
      build_lattice(scene, {c.spacing, c.connectivity, scene.map().spec().bounds.min});
  const int directions = half_directions(c.connectivity);
  std::size_t edges = 0;
  for (std::size_t n = 0; n < lattice.size(); ++n) {
    const Vec3 p = lattice.position(n);
    ASSERT_EQ(lattice.free(n), !blocked(scene, p, p)) << "node " << n;
    for (int d = 0; d < directions; ++d) {
      geom::Vec3 q = p;
      Index3 to = lattice.index(n);
      for (int k = 0; k < 3; ++k) to[k] += kDirection[d][k];
      const auto other = lattice.node(to);
      const bool free = lattice.mask(n) & 1u << d;
      if (!other) {
        ASSERT_FALSE(free);
        continue;
      }
      q = lattice.position(*other);
      ASSERT_EQ(free, !blocked(scene, p, q)) << "edge " << d << " of node " << n;
      ASSERT_EQ(free, (lattice.mask(*other) & 1u << (kHalfDirections + d)) != 0);
      edges += free;
    }
  }
  EXPECT_EQ(edges, lattice.counts().edges);
  EXPECT_GT(edges, 100u);
}

INSTANTIATE_TEST_SUITE_P(Kinds, LatticeProperty,
                         testing::Values(Case{Connectivity::six, 5, {1, 1, 1}},
                                         Case{Connectivity::eighteen, 4, {0.5, 0.5, 0}},
                                         Case{Connectivity::twenty_six, 5, {1, 1, 1}},
                                         Case{Connectivity::twenty_six, 3.3, {0.7, 0.7, 0.2}}));

TEST(Lattice, IsTheSameForAnyNumberOfThreads) {
  const CollisionScene scene(support::random_city(22, 200, 300), {"box", {1, 1, 1}}, 0.5);
  std::string bytes[3];
  const unsigned threads[] = {1, 2, 7};
  for (int i = 0; i < 3; ++i) {
    std::ostringstream out;
    write_lattice(out, build_lattice(scene, {5, Connectivity::twenty_six, Vec3(0.3, 0, 0)},
                                     {threads[i], {}}));
    bytes[i] = out.str();
  }
  EXPECT_EQ(bytes[0], bytes[1]);
  EXPECT_EQ(bytes[0], bytes[2]);
}

}  // namespace
}  // namespace plan
