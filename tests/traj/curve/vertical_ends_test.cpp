#include "traj/curve/vertical_ends.h"

#include <gtest/gtest.h>

#include "traj/scenes.h"

namespace traj {
namespace {

using testing::scene_of;

// A block with a roof at 10 m, and another that hangs from 20 m up.
geom::CollisionScene yard() {
  return scene_of({{{0, 0, 0}, {10, 10, 10}}, {{20, 0, 20}, {30, 10, 30}}});
}

TEST(GroundBelow, IsTheRoofOrTheFloor) {
  EXPECT_EQ(ground_below(yard(), {5, 5, 15}), 10);
  EXPECT_EQ(ground_below(yard(), {15, 5, 15}), 0);
  EXPECT_EQ(ground_below(yard(), {25, 5, 15}), 0) << "what hangs above does not carry";
  EXPECT_EQ(ground_below(yard(), {25, 5, 35}), 30);
}

TEST(GroundBelow, IsTheHighestOfWhatIsBelow) {
  const auto scene =
      scene_of({{{0, 0, 0}, {10, 10, 4}}, {{0, 0, 6}, {10, 10, 9}}, {{0, 0, 20}, {10, 10, 30}}});
  EXPECT_EQ(ground_below(scene, {5, 5, 12}), 9);
  EXPECT_EQ(ground_below(scene, {5, 5, 5}), 4) << "between the two";
  EXPECT_EQ(ground_below(scene, {10, 10, 12}), 9) << "sinking along an edge touches it";
  EXPECT_EQ(ground_below(scene, {10.001, 10, 12}), 0);
}

}  // namespace
}  // namespace traj
