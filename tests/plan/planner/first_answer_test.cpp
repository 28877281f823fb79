#include "planner/first_answer.h"

#include <gtest/gtest.h>

#include "geom/base/parallel.h"
#include "plan/detours.h"

namespace plan {
namespace {

constexpr Quality kQualities[] = {Quality::fast, Quality::normal, Quality::best};

void expect_free(const geom::CollisionScene& scene, const geom::Polyline& path,
                 std::uint64_t seed) {
  for (std::size_t i = 1; i < path.size(); ++i) {
    ASSERT_TRUE(scene.free(path[i - 1], path[i])) << "seed " << seed;
  }
}

TEST(FirstAnswer, IsFreeAndNoAnswerIsLonger) {
  int found = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const auto detour = detour_for(seed);
    if (!detour) continue;
    const auto& [scene, from, to, length] = *detour;
    Planner planner(scene);
    for (const Quality quality : kQualities) {
      const PlanOptions options{.quality = quality};
      const auto first = first_answer(scene, {from, to, options});
      if (!first) continue;
      ++found;
      const geom::Polyline& path = first->found.path;
      EXPECT_EQ(path.front(), from) << "seed " << seed;
      EXPECT_EQ(path.back(), to) << "seed " << seed;
      expect_free(scene, path, seed);
      const PlanResult answer = planner.plan(from, to, options);
      ASSERT_EQ(answer.status, PathStatus::found) << "seed " << seed;
      expect_free(scene, answer.path, seed);
      EXPECT_LE(geom::length(answer.path), geom::length(path)) << "seed " << seed;
    }
  }
  EXPECT_GT(found, 100);
}

TEST(FirstAnswer, IsNotSoughtForARawPath) {
  const auto scene = scene_of({{{15, 10, 0}, {25, 22, 30}}}, {{0, 0, 0}, {40, 40, 40}});
  const Vec3 from(2, 20, 5);
  const Vec3 to(38, 20, 5);
  const PlanOptions raw{.raw = true};
  EXPECT_FALSE(first_answer(scene, {from, to, raw}));
  const PlanOptions fast{.quality = Quality::fast};
  const auto first = first_answer(scene, {from, to, fast});
  ASSERT_TRUE(first);
  EXPECT_EQ(first->route, Route(OwnRoute::chain));
  EXPECT_TRUE(suffices(*first, {from, to, fast}));
  const PlanOptions normal;
  EXPECT_FALSE(suffices(*first, {from, to, normal}));  // a seventh longer than the straight line
}

TEST(FirstAnswer, IsByTreesWhereNoHalfPlaneHasAWay) {
  const auto scene = scene_of({{{30, -1, -1}, {35, 80, 21}}, {{65, 20, -1}, {70, 101, 21}}},
                              {{0, 0, 0}, {100, 100, 20}}, {1, 1, 1});
  const PlanOptions fast{.quality = Quality::fast};
  const auto first = first_answer(scene, {{10, 10, 10}, {90, 90, 10}, fast});
  ASSERT_TRUE(first);
  EXPECT_EQ(first->route, Route(SamplingMethod::rrt_connect));
}

TEST(FirstAnswer, IsTheSameInAnyThread) {
  std::vector<Detour> detours;
  for (std::uint64_t seed = 0; detours.size() < 24; ++seed) {
    if (auto detour = detour_for(seed)) detours.push_back(std::move(*detour));
  }
  const auto paths = [&](unsigned threads) {
    std::vector<geom::Polyline> out(detours.size() * 3);
    geom::parallel_for(out.size(), {threads}, [&](std::size_t i) {
      const Detour& detour = detours[i / 3];
      const PlanOptions options{.quality = kQualities[i % 3]};
      Planner planner(detour.scene);
      out[i] = planner.plan(detour.from, detour.to, options).path;
    });
    return out;
  };
  EXPECT_EQ(paths(1), paths(3));
}

}  // namespace
}  // namespace plan
