#include "plan/roadmap/roadmap.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "path/taut.h"
#include "plan/planner/plan.h"
#include "plan/scenes.h"
#include "roadmap/tiled.h"
#include "support/random_city.h"

namespace plan {
namespace {

const geom::Aabb kBounds{{-50, -50, 0}, {50, 50, 60}};

// The shortest way over and round one wall, by trying all heights of its edges.
TEST(Roadmap, FindsTheShortestWayOverAWall) {
  const auto scene = scene_of({{{-1, -60, 0}, {1, 60, 20}}}, kBounds, {1, 1, 1});
  const Roadmap roadmap = build_roadmap(scene, {});
  RoadmapSearch search(scene, roadmap);
  const Vec3 from(-20, -10, 5);
  const Vec3 to(20, 30, 5);
  const RoadmapResult found = search.search(from, to, {});
  ASSERT_EQ(found.paths.size(), 1u);
  const geom::Polyline path = taut(scene, found.paths[0]);
  // Unfolded: 18 m and 16 m up to the edge, 4 m across, and the same down; 40 m along. Bends keep a
  // millimetre off, and the last round of pulling may leave as much.
  const double flat = 2 * std::hypot(17.999, 16.001) + 4.002;
  EXPECT_NEAR(geom::length(path), std::hypot(flat, 40.0), 1e-3);
}

// However many bends a closed room does not see, only so many of them are looked at.
TEST(Roadmap, GivesUpWhereTheStartSeesNothing) {
  std::vector<geom::Aabb> boxes = {{{-10, -10, 0}, {10, -9, 9}},
                                   {{-10, 9, 0}, {10, 10, 9}},
                                   {{-10, -10, 0}, {-9, 10, 9}},
                                   {{9, -10, 0}, {10, 10, 9}},
                                   {{-10, -10, 9}, {10, 10, 10}}};
  for (double x = -45; x < 45; x += 9) boxes.push_back({{x, 20, 0}, {x + 2, 22, 9}});
  const auto scene = scene_of(boxes, kBounds, {1, 1, 1});
  const Roadmap roadmap = build_roadmap(scene, {});
  ASSERT_GT(roadmap.bends(), 50u);
  RoadmapSearch search(scene, roadmap);
  for (const std::size_t limit : {1u, 1000u}) {
    const RoadmapResult none = search.search({0, 0, 4}, {0, 40, 4}, {limit});
    EXPECT_TRUE(none.gave_up);
    EXPECT_TRUE(none.paths.empty());
    EXPECT_EQ(none.settled, 0u);
  }
}

// A box that ends a hair below a flat one covers nothing of its upright edges, which have no
// length.
TEST(Roadmap, BendsAtTheCornersOfAFlatBox) {
  const auto scene = scene_of({{{0, 0, 5}, {10, 10, 5}}, {{-1, -1, 0}, {12, 12, 4.9985}}}, kBounds);
  const Roadmap roadmap = build_roadmap(scene, {});
  const std::vector<Bend> bends = flattened(roadmap).tiles.bends;
  EXPECT_EQ(
      std::count_if(bends.begin(), bends.end(),
                    [](const Bend& bend) { return bend.axis == 2 && bend.position.z() == 5; }),
      4);
}

class RoadmapProperty : public testing::TestWithParam<std::uint64_t> {};

TEST_P(RoadmapProperty, BendsAreFreeAndEdgesSeeEachOtherBothWays) {
  const auto scene = small_city(GetParam());
  const Roadmap roadmap = build_roadmap(scene, {10, 120, {}}, {2, {}});
  const auto [tiles, edges] = flattened(roadmap);
  ASSERT_GT(tiles.bends.size(), 100u);
  ASSERT_EQ(edges.first.size(), tiles.bends.size() + 1);
  for (std::size_t i = 0; i < tiles.bends.size(); ++i) {
    const Vec3& p = tiles.bends[i].position;
    ASSERT_TRUE(scene.free(p));
    for (const std::uint32_t j : edges.of(i)) {
      const Vec3& q = tiles.bends[j].position;
      ASSERT_LE((q - p).norm(), 120);
      ASSERT_FALSE(scene.hits(p, q));
      const auto back = edges.of(j);
      ASSERT_TRUE(std::find(back.begin(), back.end(), i) != back.end());
    }
  }
}

// Free places that do not see each other.
std::pair<Vec3, Vec3> blocked_pair(const geom::CollisionScene& scene, support::Random& random,
                                   double side, double high) {
  const auto point = [&] {
    return Vec3(random.uniform(-side, side), random.uniform(-side, side), random.uniform(1, high));
  };
  while (true) {
    const Vec3 from = point();
    const Vec3 to = point();
    if (scene.free(from) && scene.free(to) && !scene.free(from, to)) return {from, to};
  }
}

// A search that finds tiles loaded by others gives what the first gives.
TEST_P(RoadmapProperty, AnswersDoNotDependOnEarlierSearches) {
  const auto scene = small_city(GetParam());
  const Roadmap roadmap = build_roadmap(scene, {10, 60, {}}, {2, {}});
  RoadmapSearch kept(scene, roadmap);
  support::Random random(GetParam());
  int compared = 0;
  while (compared < 30) {
    const auto [from, to] = blocked_pair(scene, random, 190, 20);
    ++compared;
    const RoadmapResult a = kept.search(from, to, {20000, 4, 0.1});
    const RoadmapResult b = RoadmapSearch(scene, roadmap).search(from, to, {20000, 4, 0.1});
    ASSERT_EQ(a.settled, b.settled);
    ASSERT_EQ(a.paths, b.paths);
  }
}

TEST_P(RoadmapProperty, FindsTheSameWaysWhereEdgesAreYetToBeLookedFor) {
  const auto scene = small_city(GetParam());
  const Roadmap roadmap = build_roadmap(scene, {10, 120, {}}, {2, {}});
  RoadmapSearch by_edges(scene, roadmap);
  RoadmapSearch by_bends(scene, flattened(roadmap).tiles.bends, roadmap.spec.reach);
  support::Random random(GetParam());
  int compared = 0;
  while (compared < 40) {
    const auto [from, to] = blocked_pair(scene, random, 150, 20);
    ++compared;
    const RoadmapResult a = by_edges.search(from, to, {});
    const RoadmapResult b = by_bends.search(from, to, {});
    ASSERT_EQ(a.paths.size(), b.paths.size());
    if (a.paths.empty()) continue;
    const double shortest = geom::length(a.paths[0]);
    ASSERT_NEAR(shortest, geom::length(b.paths[0]), 1e-9);
    RoadmapLimits limits;
    for (RoadmapSearch* search : {&by_edges, &by_bends}) {
      limits.shorter = shortest + 1e-6;
      const RoadmapResult again = search->search(from, to, limits);
      ASSERT_EQ(again.paths.size(), 1u);
      ASSERT_NEAR(geom::length(again.paths[0]), shortest, 1e-9);
      limits.shorter = shortest - 1e-6;
      ASSERT_TRUE(search->search(from, to, limits).paths.empty());
    }
  }
}

TEST_P(RoadmapProperty, PathsAreFreeAndHardlyLongerThanTheFinestLattices) {
  const auto scene = small_city(GetParam());
  const Roadmap roadmap = build_roadmap(scene, {});
  Planner by_roadmap(scene, nullptr, &roadmap);
  Planner by_lattice(scene, nullptr);
  support::Random random(GetParam());
  double roadmaps = 0;
  double lattices = 0;
  int compared = 0;
  while (compared < 40) {
    const auto [from, to] = blocked_pair(scene, random, 150, 40);
    const PlanResult a = by_roadmap.plan(from, to, {});
    const PlanResult b = by_lattice.plan(from, to, {});
    ASSERT_EQ(a.status, b.status);
    if (a.status != PathStatus::found) continue;
    for (std::size_t i = 1; i < a.path.size(); ++i) {
      ASSERT_TRUE(scene.free(a.path[i - 1], a.path[i]));
    }
    roadmaps += geom::length(a.path);
    lattices += geom::length(b.path);
    ++compared;
  }
  EXPECT_LT(roadmaps, 1.0005 * lattices);
}

INSTANTIATE_TEST_SUITE_P(Cities, RoadmapProperty, testing::Values(1, 2, 3));

}  // namespace
}  // namespace plan
