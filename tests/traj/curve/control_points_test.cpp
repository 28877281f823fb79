#include "traj/curve/control_points.h"

#include <gtest/gtest.h>

#include "traj/scenes.h"

namespace traj {
namespace {

TEST(ControlPoints, AreThoseOfAllSegmentsInOrder) {
  const Trajectory t = testing::random_trajectory(1, 2);
  const std::vector<Vec3> points = control_points(t);
  ASSERT_EQ(points.size(), 2u * kPoints);
  EXPECT_EQ(points.front(), t.segments[0].point.front());
  EXPECT_EQ(points[kPoints], t.segments[1].point.front());
  EXPECT_EQ(points.back(), t.segments[1].point.back());
  EXPECT_TRUE(control_points({}).empty());
}

}  // namespace
}  // namespace traj
