#include "path/boxes_within.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "plan/scenes.h"

namespace plan {
namespace {

TEST(BoxesWithin, AreAllThatTheWaysMeetAndNoneThatTheyCannot) {
  const auto scene = random_scene(7, 400, 300, {0.5, 0.5, 0.5});
  support::Random random(7);
  std::size_t most = 0;
  for (int i = 0; i < 100; ++i) {
    Vec3 p[2];
    for (Vec3& end : p) {
      for (int k = 0; k < 3; ++k) end[k] = random.uniform(0, 300);
    }
    const ShortWays ways{p[0], p[1], (p[1] - p[0]).norm() * random.uniform(1, 1.2) + 1};
    const auto found = boxes_within(scene, ways, 400);
    ASSERT_TRUE(found) << i;
    ASSERT_TRUE(std::is_sorted(found->begin(), found->end())) << i;
    for (std::size_t k = 0; k < scene.map().size(); ++k) {
      const geom::Aabb box = scene.grown(k);
      const bool in = std::binary_search(found->begin(), found->end(), k);
      ASSERT_TRUE(!in || ways.may_meet(box)) << i;
      const Vec3 middle = 0.5 * (box.min + box.max);
      ASSERT_TRUE(in || !(ways.hold(middle) || ways.hold(box.min))) << i;
    }
    most = std::max(most, found->size());
  }
  EXPECT_GT(most, 20u);
}

TEST(BoxesWithin, AreNothingWhereTheyAreTooMany) {
  const auto scene = random_scene(7, 400, 300, {0.5, 0.5, 0.5});
  const ShortWays all{{0, 0, 0}, {300, 300, 300}, 2000};
  EXPECT_EQ(boxes_within(scene, all, 400)->size(), 400u);
  EXPECT_FALSE(boxes_within(scene, all, 399));
}

}  // namespace
}  // namespace plan
