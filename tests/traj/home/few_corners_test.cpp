#include "home/few_corners.h"

#include <gtest/gtest.h>

namespace traj {
namespace {

const PlanBox kBounds{{0, 0}, {100, 100}};

Outline square(double x, double y, double size) {
  return outline_of({{x, y}, {x + size, y + size}});
}

TEST(FewCorners, TakesStepsOutBetweenWhatIsKept) {
  std::vector<Vec2> stairs;
  for (int i = 0; i < 20; ++i) {
    stairs.push_back({2.0 * i, 2.0 * i});
    stairs.push_back({2.0 * i + 2, 2.0 * i});
  }
  stairs.push_back({40, 60});
  stairs.push_back({0, 60});
  ASSERT_TRUE(is_apart(stairs));
  const Outline inside = square(5, 45, 10);
  const Outline outside = square(30, 5, 10);
  const Kept kept({inside, outside}, kBounds);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const std::vector<Vec2> ring = few_corners(stairs, kept, seed);
    EXPECT_LE(ring.size(), 5u);
    EXPECT_TRUE(is_apart(ring));
    for (const Vec2& p : inside) EXPECT_TRUE(geom::contains({ring, {}}, p));
    for (const Vec2& p : outside) EXPECT_FALSE(geom::contains({ring, {}}, p));
  }
}

TEST(FewCorners, LeavesTheRingWhereNothingMayGo) {
  const std::vector<Vec2> ring = square(10, 10, 10);
  const Kept kept({square(10.001, 10.001, 9.998)}, kBounds);
  EXPECT_LE(few_corners(ring, kept, 0).size(), 4u);
  EXPECT_GE(few_corners(ring, kept, 0).size(), 3u);
}

TEST(IsApart, RefusesRingsThatCrossOrTouch) {
  EXPECT_TRUE(is_apart(square(0, 0, 1)));
  EXPECT_FALSE(is_apart({{0, 0}, {1, 1}, {1, 0}, {0, 1}}));
  EXPECT_FALSE(is_apart({{0, 0}, {1, 0}}));
  EXPECT_FALSE(is_apart({{0, 0}, {4, 0}, {4, 4}, {2, 1e-4}, {0, 4}})) << "a corner near an edge";
  EXPECT_FALSE(is_apart({{0, 0}, {4, 0}, {2, 1e-4}})) << "a spike";
}

}  // namespace
}  // namespace traj
