#include "planner/bend_steps.h"

#include <gtest/gtest.h>

#include "geom/base/parallel.h"
#include "plan/scenes.h"

namespace plan {
namespace {

const geom::Aabb kCube{{0, 0, 0}, {40, 40, 40}};
const Vec3 kFrom(2, 20, 5);
const Vec3 kTo(38, 20, 5);

// The shortest way past it is around a corner at its foot.
geom::CollisionScene tower() { return scene_of({{{15, 10, -1}, {25, 22, 30}}}, kCube, {1, 1, 1}); }

const geom::Polyline kDetour = {kFrom, {20, 38, 5}, kTo};

void expect_free_and_shorter(const geom::CollisionScene& scene, const std::optional<Found>& found) {
  ASSERT_TRUE(found);
  ASSERT_GE(found->path.size(), 3u);
  EXPECT_EQ(found->path.front(), kFrom);
  EXPECT_EQ(found->path.back(), kTo);
  EXPECT_LT(geom::length(found->path), geom::length(kDetour) - 5);
  for (std::size_t i = 1; i < found->path.size(); ++i) {
    EXPECT_TRUE(scene.free(found->path[i - 1], found->path[i])) << "leg " << i;
  }
}

TEST(BendSteps, FindAShorterWayThanALatticesWithoutARoadmap) {
  const auto scene = tower();
  BendSteps steps(scene, nullptr, nullptr);
  const PlanOptions options;
  EXPECT_FALSE(steps.has_roadmap());
  expect_free_and_shorter(scene, steps.better({kFrom, kTo, options}, kDetour));
}

TEST(BendSteps, FindAWayInARoadmapFromSeveralThreads) {
  const auto scene = tower();
  const Roadmap roadmap = build_roadmap(scene, RoadmapSpec{});
  BendSteps steps(scene, &roadmap, nullptr);
  const PlanOptions options;
  const Task task{kFrom, kTo, options};
  const auto first = steps.at_once(task);
  expect_free_and_shorter(scene, first);
  std::vector<geom::Polyline> paths(32);
  geom::parallel_for(paths.size(), {4}, [&](std::size_t i) {
    const auto found = i % 2 == 0 ? steps.at_once(task) : steps.exhaustively(task);
    if (found) paths[i] = found->path;
  });
  for (const geom::Polyline& path : paths) EXPECT_EQ(path, first->path);
}

TEST(BendSteps, GiveNothingThatIsNotShorter) {
  const auto scene = tower();
  BendSteps steps(scene, nullptr, nullptr);
  const PlanOptions options;
  const Task task{kFrom, kTo, options};
  const auto best = steps.better(task, kDetour);
  ASSERT_TRUE(best);
  EXPECT_FALSE(steps.better(task, best->path));
}

TEST(BendSteps, GiveUpWhereAWallHasNoGap) {
  const auto scene = scene_of({{{19, -1, -1}, {21, 41, 41}}}, kCube, {1, 1, 1});
  const Roadmap roadmap = build_roadmap(scene, RoadmapSpec{});
  BendSteps steps(scene, &roadmap, nullptr);
  const PlanOptions options;
  const Task task{kFrom, kTo, options};
  EXPECT_FALSE(steps.at_once(task));
  EXPECT_FALSE(steps.exhaustively(task));
}

TEST(BendSteps, SeekCloserBendsOnlyWhereTheBestIsAskedAndEndsAreNear) {
  const auto scene = tower();
  BendSteps steps(scene, nullptr, nullptr);
  PlanOptions options;
  options.quality = Quality::normal;
  EXPECT_FALSE(steps.closer({kFrom, kTo, options}, kDetour));
  options.quality = Quality::best;
  EXPECT_FALSE(steps.closer({kFrom, kFrom + Vec3(200, 0, 0), options}, kDetour));
  // Bends lie along the path that is given, so it passes the tower closely.
  const geom::Polyline close = {kFrom, {13.9, 23.2, 5}, {26.1, 23.2, 5}, kTo};
  const auto closer = steps.closer({kFrom, kTo, options}, close);
  ASSERT_TRUE(closer);
  EXPECT_LT(geom::length(closer->path), geom::length(close));
}

}  // namespace
}  // namespace plan
