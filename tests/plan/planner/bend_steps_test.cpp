#include "planner/bend_steps.h"

#include <gtest/gtest.h>

#include <cmath>

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
  BendSteps steps(scene, nullptr);
  const PlanOptions options;
  EXPECT_FALSE(steps.has_roadmap());
  expect_free_and_shorter(scene, steps.better({kFrom, kTo, options}, kDetour));
}

TEST(BendSteps, FindAWayInARoadmapFromSeveralThreads) {
  const auto scene = tower();
  const Roadmap roadmap = build_roadmap(scene, RoadmapSpec{});
  BendSteps steps(scene, &roadmap);
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
  BendSteps steps(scene, nullptr);
  const PlanOptions options;
  const Task task{kFrom, kTo, options};
  const auto best = steps.better(task, kDetour);
  ASSERT_TRUE(best);
  EXPECT_FALSE(steps.better(task, best->path));
}

// Towers in a row with a gate between any two, each passed on its longer side: also where one
// stretch of the path ends and the next begins, all are to be passed on the shorter one.
TEST(BendSteps, ImproveALongPathAllAlong) {
  constexpr int kTowers = 60;
  constexpr double kApart = 150;
  std::vector<geom::Aabb> boxes;
  geom::Polyline long_way = {{0.5 * kApart, 40, 20}};
  for (int n = 1; n <= kTowers; ++n) {
    const double x = n * kApart;
    const double gate = x + 0.5 * kApart;
    boxes.push_back({{x - 5, 10, -1}, {x + 5, 46, 41}});
    boxes.push_back({{gate - 0.5, -1, -1}, {gate + 0.5, 38, 41}});
    boxes.push_back({{gate - 0.5, 42, -1}, {gate + 0.5, 81, 41}});
    long_way.insert(long_way.end(), {{x - 7, 8, 20}, {x + 7, 8, 20}, {gate, 40, 20}});
  }
  const auto scene = scene_of(boxes, {{0, 0, 0}, {(kTowers + 1) * kApart, 80, 40}}, {1, 1, 1});
  BendSteps steps(scene, nullptr);
  const PlanOptions options;
  const auto found = steps.better({long_way.front(), long_way.back(), options}, long_way);
  ASSERT_TRUE(found);
  EXPECT_GT(found->expanded, 0u);
  const geom::Polyline& path = found->path;
  EXPECT_EQ(path.front(), long_way.front());
  EXPECT_EQ(path.back(), long_way.back());
  int passed = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    EXPECT_TRUE(scene.free(path[i - 1], path[i])) << "leg " << i;
    for (int n = 1; n <= kTowers; ++n) {
      const double part = (n * kApart - path[i - 1].x()) / (path[i].x() - path[i - 1].x());
      if (part < 0 || part > 1) continue;
      ++passed;
      EXPECT_GT((path[i - 1] + part * (path[i] - path[i - 1])).y(), 46) << "tower " << n;
    }
  }
  EXPECT_EQ(passed, kTowers);
  ASSERT_EQ(found->steps.size(), 2u);
  EXPECT_EQ(found->steps.back().length, geom::length(path));
}

TEST(BendSteps, CutShortAStretchWhoseEndsSeeEachOther) {
  const auto scene =
      scene_of({{{7000, 20, -1}, {7010, 46, 41}}}, {{0, 0, 0}, {9000, 80, 40}}, {1, 1, 1});
  BendSteps steps(scene, nullptr);
  const PlanOptions options;
  const geom::Polyline needless = {{10, 40, 20},   {500, 10, 20},  {1000, 70, 20}, {2500, 40, 20},
                                   {5000, 40, 20}, {6990, 48, 20}, {7020, 48, 20}, {8990, 40, 20}};
  const auto found = steps.better({needless.front(), needless.back(), options}, needless);
  ASSERT_TRUE(found);
  const double around = std::hypot(6988.999, 7.001) + 12.002 + std::hypot(1978.999, 7.001);
  EXPECT_NEAR(geom::length(found->path), around, 1e-3);
  // Not only once all is pulled taut: a search would look for bends where none are.
  ASSERT_EQ(found->steps.size(), 2u);
  EXPECT_LT(found->steps.front().length, geom::length(needless) - 3);
}

TEST(BendSteps, GiveUpWhereAWallHasNoGap) {
  const auto scene = scene_of({{{19, -1, -1}, {21, 41, 41}}}, kCube, {1, 1, 1});
  const Roadmap roadmap = build_roadmap(scene, RoadmapSpec{});
  BendSteps steps(scene, &roadmap);
  const PlanOptions options;
  const Task task{kFrom, kTo, options};
  EXPECT_FALSE(steps.at_once(task));
  EXPECT_FALSE(steps.exhaustively(task));
}

TEST(BendSteps, SeekCloserBendsOnlyWhereTheBestIsAskedAndEndsAreNear) {
  const auto scene = tower();
  BendSteps steps(scene, nullptr);
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
