#include "bound/link_path.h"

#include <gtest/gtest.h>

#include "plan/scenes.h"

namespace plan {
namespace {

// A wall with a way over its edge (a part 9 m up) or around its end (a part near by).
struct Wall {
  geom::CollisionScene scene = scene_of({{{9, 0, 0}, {11, 12, 9}}}, {{0, 0, 0}, {20, 20, 20}});
  Level level;
  std::vector<LineLabel> go;

  Wall() {
    const geom::Aabb box = scene.grown(0);
    const auto edge = [&](double x, std::int8_t out) {
      return EdgePart{{x, box.max.y(), 1}, {x, box.max.y(), 3}, 2, {out, 1}};
    };
    level.parts = {{{5, 11, 2}, {5, 11, 2}, kCorner, {}},
                   {{15, 11, 2}, {15, 11, 2}, kCorner, {}},
                   edge(box.min.x(), -1),
                   edge(box.max.x(), 1)};
    level.links.resize(4);
    const auto link = [&](std::uint32_t from, std::uint32_t to, Sight sight) {
      level.links[from].push_back({to, 3, 3, sight, {}});
    };
    link(0, 1, Sight::unknown);  // through the wall: the scene says no
    link(0, 2, Sight::open);
    link(0, 3, Sight::hidden);
    link(2, 3, Sight::unknown);
    link(2, 1, Sight::unknown);
    link(3, 1, Sight::unknown);
    go.assign(8, {0, 0});
  }
  geom::Polyline path(double limit, std::size_t most = 1000) {
    steps = 0;
    return link_path(scene, level, go, limit, most, steps);
  }
  std::size_t steps = 0;
};

TEST(LinkPath, IsTheShortestFreeOneBesideMiddles) {
  Wall wall;
  const geom::Polyline path = wall.path(100);
  ASSERT_EQ(path.size(), 4u);
  EXPECT_EQ(path.front(), wall.level.parts[kStart].low);
  EXPECT_EQ(path.back(), wall.level.parts[kGoal].low);
  EXPECT_NEAR((path[1] - Vec3(9, 12, 2)).norm(), 1e-3 * std::sqrt(2), 1e-6);
  for (std::size_t i = 1; i < path.size(); ++i) EXPECT_TRUE(wall.scene.free(path[i - 1], path[i]));
  EXPECT_GT(wall.steps, 0u);
}

TEST(LinkPath, IsEmptyWhereNoneIsShortEnough) {
  Wall wall;
  const double length = geom::length(wall.path(100));
  EXPECT_TRUE(wall.path(length).empty());
  EXPECT_FALSE(wall.path(length + 1e-9).empty());
  wall.go[4] = wall.go[5] = {90, 90};  // known to be far behind the first part
  EXPECT_TRUE(wall.path(80).empty());
}

}  // namespace
}  // namespace plan
