#include "shape/near_edges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/random_city.h"

namespace geom {
namespace {

// Rings that cross each other and themselves, with corners that repeat and levels that coincide.
std::vector<CoverEdge> random_edges(support::Random& random, int rings) {
  std::vector<CoverEdge> out;
  for (int ring = 0; ring < rings; ++ring) {
    std::vector<Vec2> corners(3 + random.below(9));
    for (Vec2& c : corners) c = {random.stepped(-9, 9, 0.5), random.stepped(-9, 9, 0.5)};
    add_edges(corners, ring, out);
  }
  return out;
}

Rectangle random_region(support::Random& random) {
  const Vec2 a(random.stepped(-9, 9, 0.25), random.stepped(-9, 9, 0.25));
  const Vec2 size(random.below(3) ? random.uniform(0, 4) : 0, random.below(3) ? 0.5 : 0);
  return {a, a + size};
}

// Mostly on the sides and corners of the region.
Vec2 random_point(support::Random& random, const Rectangle& r) {
  Vec2 p;
  for (int k = 0; k < 2; ++k) {
    const double t = std::array{0.0, 1.0, 0.5, random.uniform(0, 1)}[random.below(4)];
    p[k] = std::clamp(r.min[k] + t * (r.max[k] - r.min[k]), r.min[k], r.max[k]);
  }
  return p;
}

TEST(NearEdges, SayOfPointsOfARegionWhatAllEdgesSay) {
  support::Random random(7);
  int insides = 0;
  int near = 0;
  for (int round = 0; round < 4000; ++round) {
    const int rings = 1 + static_cast<int>(random.below(3));
    const std::vector<CoverEdge> edges = random_edges(random, rings);
    std::vector<const CoverEdge*> all;
    for (const CoverEdge& edge : edges) all.push_back(&edge);
    const Rectangle region = random_region(random);
    const double reach = random.uniform(0, 2);
    NearEdges some(static_cast<std::size_t>(rings));
    some.gather(all, all, random_region(random), 3);  // nothing of it may remain
    some.gather(all, all, region, reach);
    for (int i = 0; i < 20; ++i) {
      const Vec2 p = random_point(random, region);
      Winding winding(static_cast<std::size_t>(rings));
      bool odd = false;
      for (const CoverEdge& edge : edges) {
        if (!edge.is_right_of(p)) continue;
        winding.count(edge);
        odd = !odd;
      }
      const bool inside = odd || winding.inside();
      ASSERT_EQ(some.is_inside(p), inside) << round << ": " << p.transpose();
      insides += inside;
      const double squared = std::pow(random.uniform(0, reach), 2);
      const bool is_near = std::any_of(edges.begin(), edges.end(),
                                       [&](const CoverEdge& e) { return e.is_within(squared, p); });
      ASSERT_EQ(some.is_near(squared, p), is_near) << round << ": " << p.transpose();
      near += is_near;
    }
  }
  EXPECT_GT(insides, 15000);  // of 80,000
  EXPECT_GT(near, 15000);
}

TEST(NearEdges, LeaveOutWhatIsFarAway) {
  const std::vector<CoverEdge> edges = {{{0, 0}, {0, 9}, 0, 1}, {{5, 0}, {5, 9}, 0, -1}};
  const std::vector<const CoverEdge*> all = {&edges[0], &edges[1]};
  NearEdges some(1);
  some.gather(all, all, {{1, 4}, {2, 5}}, 1.5);
  ASSERT_EQ(some.near().size(), 1u);
  EXPECT_EQ(some.near()[0], &edges[0]);
  EXPECT_TRUE(some.beside().empty());
  EXPECT_TRUE(some.is_inside({1.5, 4.5}));
}

}  // namespace
}  // namespace geom
