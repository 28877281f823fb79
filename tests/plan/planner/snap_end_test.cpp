#include "plan/planner/snap_end.h"

#include <gtest/gtest.h>

#include "plan/scenes.h"

namespace plan {
namespace {

using geom::Vec3;

const geom::Aabb kCube{{0, 0, 0}, {40, 40, 40}};

TEST(NearestFree, IsThePointItselfWhereFree) {
  EXPECT_EQ(nearest_free(scene_of({}, kCube), {2, 2, 2}, 5), Vec3(2, 2, 2));
}

TEST(NearestFree, LeavesOverlappingBoxesTogether) {
  // Out of the first box sideways leads into the second: the way out is up.
  const auto scene = scene_of({{{10, 10, 0}, {20, 20, 8}}, {{6, 6, 0}, {11, 24, 8}}}, kCube);
  const auto found = nearest_free(scene, {10.5, 15, 6}, 50);
  ASSERT_TRUE(found);
  EXPECT_NEAR((*found - Vec3(10.5, 15, 8.001)).norm(), 0, 1e-6);
  EXPECT_EQ(nearest_free(scene, {10.5, 15, 6}, 1.9), std::nullopt);
}

// No random free point is nearer, and what is returned is free and within the radius.
TEST(NearestFree, IsAsNearAsAnyRandomFreePoint) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    SCOPED_TRACE(seed);
    const auto scene = random_scene(seed, 120, 12, Vec3::Constant(0.4));
    support::Random random(seed);
    for (int i = 0; i < 30; ++i) {
      const Vec3 p(random.uniform(-1, 13), random.uniform(-1, 13), random.uniform(-1, 13));
      const auto found = nearest_free(scene, p, 30);
      if (!found) continue;
      EXPECT_TRUE(scene.free(*found));
      const double d = (*found - p).norm();
      for (int k = 0; k < 300; ++k) {
        const Vec3 q =
            p + Vec3(random.uniform(-d, d), random.uniform(-d, d), random.uniform(-d, d));
        if (!scene.free(q)) continue;
        EXPECT_GT((q - p).norm(), d - 2e-3);  // a millimetre along each axis
      }
    }
  }
}

}  // namespace
}  // namespace plan
