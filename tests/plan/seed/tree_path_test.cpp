#include "seed/tree_path.h"

#include <gtest/gtest.h>

#include "plan/scenes.h"
#include "seed/first_path.h"

namespace plan {
namespace {

using geom::Vec3;

const geom::Aabb kRoom{{0, 0, 0}, {100, 100, 20}};

TEST(TreePath, FindsAWayThatNoHalfPlaneHas) {
  // Two walls from floor to ceiling, with doors at opposite ends.
  const auto scene =
      scene_of({{{30, -1, -1}, {35, 80, 21}}, {{65, 20, -1}, {70, 101, 21}}}, kRoom, {1, 1, 1});
  const Vec3 from(10, 10, 10);
  const Vec3 to(90, 90, 10);
  EXPECT_TRUE(first_path(scene, from, to).empty());
  const geom::Polyline path = tree_path(scene, from, to);
  ASSERT_FALSE(path.empty());
  EXPECT_EQ(path.front(), from);
  EXPECT_EQ(path.back(), to);
  for (std::size_t i = 1; i < path.size(); ++i) {
    EXPECT_TRUE(scene.free(path[i - 1], path[i])) << "leg " << i;
  }
  EXPECT_EQ(path, tree_path(scene, from, to));
}

TEST(TreePath, IsNothingWhereThereIsNoWay) {
  const auto scene = scene_of({{{30, -1, -1}, {35, 101, 21}}}, kRoom, {1, 1, 1});
  EXPECT_TRUE(tree_path(scene, {10, 10, 10}, {90, 90, 10}).empty());
}

}  // namespace
}  // namespace plan
