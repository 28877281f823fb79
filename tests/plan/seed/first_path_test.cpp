#include "seed/first_path.h"

#include <gtest/gtest.h>

#include <cmath>

#include "plan/detours.h"

namespace plan {
namespace {

const geom::Aabb kTown{{-100, -100, 0}, {300, 100, 120}};
const Vec3 kFrom(0, 0, 5);
const Vec3 kTo(100, 0, 5);

TEST(FirstPath, GoesRoundATowerAndOverAHouse) {
  const auto tower = scene_of({{{40, -20, 0}, {60, 10, 99}}}, kTown);
  const geom::Polyline round = first_path(tower, kFrom, kTo);
  EXPECT_LT(geom::length(round), 2 * std::hypot(40, 10) + 20 + 1);
  const auto house = scene_of({{{40, -90, 0}, {60, 90, 15}}}, kTown);
  const geom::Polyline over = first_path(house, kFrom, kTo);
  EXPECT_LT(geom::length(over), 2 * std::hypot(40, 10) + 20 + 1);
}

TEST(FirstPath, IsTheFirstThatIsShortEnough) {
  const auto scene = scene_of({{{40, -20, 0}, {60, 10, 40}}}, kTown);
  const double any = geom::length(first_path(scene, kFrom, kTo, {.enough = 100}));
  const double best = geom::length(first_path(scene, kFrom, kTo));
  EXPECT_NEAR(any, 2 * std::hypot(40, 35) + 20, 0.01);  // upright
  EXPECT_LT(best, any - 10);
}

TEST(FirstPath, IsNothingWhereNoHalfPlaneHasAWay) {
  const auto scene = scene_of({{{50, -100, 0}, {51, 100, 120}}}, kTown);
  EXPECT_TRUE(first_path(scene, kFrom, kTo).empty());
}

TEST(FirstPath, IsFreeAndNoShorterThanAPathCanBe) {
  int found = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const auto detour = detour_for(seed);
    if (!detour) continue;
    const auto& [scene, from, to, length] = *detour;
    const geom::Polyline path = first_path(scene, from, to);
    if (path.empty()) continue;
    ++found;
    EXPECT_EQ(path.front(), from) << "seed " << seed;
    EXPECT_EQ(path.back(), to) << "seed " << seed;
    for (std::size_t i = 1; i < path.size(); ++i) {
      ASSERT_TRUE(scene.free(path[i - 1], path[i])) << "seed " << seed;
    }
    EXPECT_GT(geom::length(path), 0.99 * length) << "seed " << seed;
  }
  EXPECT_GT(found, 30);
}

}  // namespace
}  // namespace plan
