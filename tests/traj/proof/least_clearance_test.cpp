#include "proof/least_clearance.h"

#include <gtest/gtest.h>

#include "traj/scenes.h"

namespace traj {
namespace {

// More boxes at about one distance than the search halves a way for.
TEST(LeastClearance, StaysExactWhereHalvingEnds) {
  constexpr int kBoxes = 500'000;
  std::vector<geom::Aabb> boxes;
  for (int i = 0; i < kBoxes; ++i) {
    const double top = i == 123'457 ? 9.001 : 9;
    boxes.push_back({Vec3(i, 0, 0), Vec3(i + 0.5, 1, top)});
  }
  const auto scene = testing::scene_of(boxes, {Vec3(-10, -10, 0), Vec3(kBoxes + 10, 10, 100)});
  const Leg leg{Vec3(0, 0.5, 20), Vec3(kBoxes, 0.5, 20), 0, 1};
  const auto least = least_clearance(scene, std::vector<Leg>{leg});
  ASSERT_TRUE(least);
  EXPECT_NEAR(least->value, 20 - 9.001, 1e-9);
}

// A flight over low roofs that passes one tower: the trees of roofs further than that are not
// built.
TEST(LeastClearance, BuildsNoTreesOfWhatIsFurther) {
  std::vector<geom::Aabb> boxes;
  for (int x = 0; x < 300; ++x) {
    for (int y = 0; y < 100; ++y) {
      const double top = x == 2 && y == 50 ? 29 : 5;
      boxes.push_back({Vec3(30 * x, 30 * y, 0), Vec3(30 * x + 20, 30 * y + 20, top)});
    }
  }
  const auto scene = testing::scene_of(boxes, {Vec3(-10, -10, 0), Vec3(9100, 3100, 100)});
  Trajectory trajectory;
  for (double x = 0; x < 9000; x += 180) {
    trajectory.segments.push_back(hermite({Vec3(x, 1510, 30)}, {Vec3(x + 180, 1510, 30)}, 20));
  }
  const auto least = least_clearance(scene, BoxTimes(), pieces_of(trajectory));
  ASSERT_TRUE(least);
  EXPECT_NEAR(least->value, 1, 1e-3);
  EXPECT_GT(scene.counts().groups, 40u);
  EXPECT_LT(scene.counts().built, 5u);
}

TEST(LeastClearance, IsNothingOnAMapWithoutObstacles) {
  const auto scene = testing::scene_of({});
  EXPECT_FALSE(least_clearance(scene, std::vector<Leg>{{Vec3(0, 0, 10), Vec3(5, 0, 10), 0, 1}}));
}

}  // namespace
}  // namespace traj
