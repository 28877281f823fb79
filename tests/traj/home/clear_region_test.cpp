#include "home/clear_region.h"

#include <gtest/gtest.h>

#include "geom/shape/hull.h"
#include "support/random_city.h"
#include "traj/home/home_case.h"

namespace traj {
namespace {

using testing::small_vehicle;
using testing::town;

Prism random_prism(support::Random& random) {
  std::vector<Vec2> plan;
  const Vec2 middle(random.uniform(-60, 60), random.uniform(-60, 60));
  const double size = random.below(3) == 0 ? 0.0 : random.uniform(0, 12);
  for (int i = 0; i < 5; ++i) {
    plan.emplace_back(middle.x() + random.uniform(-size, size),
                      middle.y() + random.uniform(-size, size));
  }
  const double low = random.uniform(1, 70);
  return {plan_hull(plan), low, low + random.uniform(0, 8)};
}

// Whether the hull meets a box of the map grown by the vehicle and `more`, box by box.
bool meets_any(const geom::CollisionScene& scene, const std::vector<Vec3>& hull, double more) {
  for (std::size_t i = 0; i < scene.map().size(); ++i) {
    const geom::Aabb box = scene.grown(i);
    const Vec3 by = Vec3::Constant(more);
    if (geom::hull_meets(hull, {box.min - by, box.max + by})) return true;
  }
  return false;
}

TEST(ClearJoin, AgreesWithEachBoxByItself) {
  int clear = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    support::Random random(seed + 100);
    const auto scene = small_vehicle(support::random_city(seed, 60, 150));
    for (int i = 0; i < 60; ++i) {
      const Prism from = random_prism(random);
      const Vec3 to(random.uniform(-100, 100), random.uniform(-100, 100), random.uniform(1, 110));
      std::vector<Vec3> hull = corners(from);
      hull.push_back(to);
      const bool free = clear_join(scene, from, to);
      clear += free;
      EXPECT_FALSE(free && meets_any(scene, hull, 0)) << "seed " << seed << " case " << i;
      EXPECT_TRUE(free || meets_any(scene, hull, 1e-6)) << "seed " << seed << " case " << i;
      EXPECT_FALSE(clear_region(scene, from) && meets_any(scene, corners(from), 0));
    }
  }
  EXPECT_GT(clear, 200);
  EXPECT_LT(clear, 2200);
}

TEST(ClearRegion, StaysInsideTheBoundsAndMayStandOnTheGround) {
  const auto scene = small_vehicle(town({}));
  const double half = scene.half().z();
  EXPECT_TRUE(clear_region(scene, {{{50, 50}}, half, 20}));
  EXPECT_FALSE(clear_region(scene, {{{50, 50}}, half - 0.01, 20}));
  EXPECT_TRUE(clear_region(scene, {{{50, 50}}, 0, 20}, 0.0));
  EXPECT_FALSE(clear_region(scene, {{{50, 50}}, 5, 60}));
  EXPECT_FALSE(clear_region(scene, {{{0.1, 50}}, 5, 20}));
  EXPECT_FALSE(clear_join(scene, {{{50, 50}}, 5, 20}, {0.1, 50, 10}));
}

TEST(ClearRegion, PassesWhatItStandsOnAndNothingElse) {
  const auto scene = small_vehicle(town({{{40, 40, 0}, {60, 60, 10}}}));
  EXPECT_TRUE(clear_region(scene, {{{50, 50}}, 10, 20}, 10.0));
  EXPECT_FALSE(clear_region(scene, {{{50, 50}}, 10, 20}, 9.9));
  EXPECT_FALSE(clear_region(scene, {{{50, 50}}, 10, 20}));
}

}  // namespace
}  // namespace traj
