#include "plan/planner/snap_end.h"

#include <gtest/gtest.h>

#include "plan/scenes.h"
#include "support/random_city.h"

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
  EXPECT_NEAR((*found - Vec3(10.5, 15, 8.03)).norm(), 0, 1e-5);
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
      if (scene.free(p)) {
        EXPECT_EQ(*found, p);
        continue;
      }
      const double room = has_room(scene, *found, kSnapRoom) ? kSnapRoom : kTightRoom;
      EXPECT_TRUE(has_room(scene, *found, room));
      const double d = (*found - p).norm();
      for (int k = 0; k < 300; ++k) {
        const Vec3 q =
            p + Vec3(random.uniform(-d, d), random.uniform(-d, d), random.uniform(-d, d));
        if (!has_room(scene, q, room)) continue;
        EXPECT_GT((q - p).norm(), d - 1e-5);  // a micrometre along each axis
      }
    }
  }
}

TEST(NearestFree, IsCloserThanAnyPointOfAFineGrid) {
  const geom::CollisionScene scene(support::random_city(41, 60, 60), {"box", {1, 1, 1}}, 0);
  support::Random random(42);
  int compared = 0;
  for (int i = 0; i < 40; ++i) {
    const Vec3 p(random.uniform(-25, 25), random.uniform(-25, 25), random.uniform(2, 20));
    const auto found = nearest_free(scene, p, 8);
    if (scene.free(p)) {
      EXPECT_EQ(*found, p);
      continue;
    }
    const double room = found && has_room(scene, *found, kSnapRoom) ? kSnapRoom : kTightRoom;
    if (found) {
      ASSERT_TRUE(has_room(scene, *found, room));
    }
    const double bound = found ? (*found - p).norm() : 8;
    for (double x = -8; x <= 8; x += 0.5) {
      for (double y = -8; y <= 8; y += 0.5) {
        for (double z = -8; z <= 8; z += 0.5) {
          const Vec3 d(x, y, z);
          if (d.norm() >= bound - 1e-5) continue;
          ASSERT_FALSE(has_room(scene, p + d, room)) << "case " << i;
        }
      }
    }
    ++compared;
  }
  EXPECT_GT(compared, 5);
}

TEST(NearestFree, KeepsRoomToRoundFromBoundsToo) {
  const auto scene = scene_of({}, kCube);
  const auto found = nearest_free(scene, {-3, 20, 50}, 20);
  ASSERT_TRUE(found);
  EXPECT_TRUE(has_room(scene, *found, kSnapRoom));
  EXPECT_FALSE(has_room(scene, *found, 1.01 * kSnapRoom));
}

TEST(NearestFree, TakesANarrowGapWhereRoomIsFar) {
  // Between two walls with 2 cm for the reference point; the next room is 4 m away.
  const auto scene = scene_of({{{10, 0, 0}, {14, 40, 40}}, {{14.02, 0, 0}, {20, 40, 40}}}, kCube);
  const auto found = nearest_free(scene, {13.9, 20, 20}, 20);
  ASSERT_TRUE(found);
  EXPECT_TRUE(has_room(scene, *found, kTightRoom));
  EXPECT_FALSE(has_room(scene, *found, kSnapRoom));
}

TEST(HasRoom, IsOfTheWholeCubeAroundAPoint) {
  const auto scene = scene_of({{{10, 10, 0}, {20, 20, 8}}}, kCube);
  const Vec3 half = scene.half();
  const Vec3 beside(10 - half[0] - 0.5, 15, 5);
  EXPECT_TRUE(has_room(scene, beside, 0.49));
  EXPECT_FALSE(has_room(scene, beside, 0.51));
  EXPECT_TRUE(has_room(scene, half, 0));  // in the corner of the bounds, touching them
  EXPECT_FALSE(has_room(scene, half, 1e-3));
}

}  // namespace
}  // namespace plan
