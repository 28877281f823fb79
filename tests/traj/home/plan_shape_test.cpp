#include "home/plan_shape.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace traj {
namespace {

Outline square(double x, double y, double size) {
  return outline_of({{x, y}, {x + size, y + size}});
}

TEST(Meet, TouchingShapesOverlapByNothing) {
  EXPECT_FALSE(meet(square(0, 0, 1), square(1, 0, 1), 1e-9));
  EXPECT_FALSE(meet(square(0, 0, 1), square(1, 1, 1), 1e-9));
  EXPECT_TRUE(meet(square(0, 0, 1), square(0.9, 0.9, 1), 1e-9));
  EXPECT_FALSE(meet({{0, 0}, {1, 1}}, {{0.6, 0}, {2, 0}}, 1e-9));
  EXPECT_TRUE(meet({{0, 0}, {1, 1}}, square(0.4, 0.4, 0.2), 1e-9));
}

TEST(Holds, IsTrueOfWhatLiesWithin) {
  EXPECT_TRUE(holds(square(0, 0, 4), square(1, 1, 2)));
  EXPECT_TRUE(holds(square(0, 0, 4), square(0, 0, 4)));
  EXPECT_FALSE(holds(square(0, 0, 4), square(3, 3, 2)));
  EXPECT_FALSE(holds({{0, 0}, {4, 4}}, {{1, 1}}));
}

TEST(OutlineAround, HoldsEachPointWithItsRoom) {
  const Outline outline = outline_around(std::vector<Vec3>{{0, 0, 5}, {10, 4, 9}}, {2, 1});
  EXPECT_EQ(outline.size(), 6u);
  for (const Vec2& p :
       {Vec2(-2, -1), Vec2(2, -1), Vec2(-2, 1), Vec2(12, 5), Vec2(12, 3), Vec2(8, 5)}) {
    EXPECT_NE(std::find(outline.begin(), outline.end(), p), outline.end());
  }
}

}  // namespace
}  // namespace traj
