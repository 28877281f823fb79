#include "plan/planner/layers.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "geom/base/error.h"
#include "geom/base/parallel.h"
#include "plan/scenes.h"

namespace plan {
namespace {

const geom::Aabb kCube{{0, 0, 0}, {40, 40, 40}};
const Layers kLayers{10, 5, 4};

TEST(Layers, GoByTheDirectionClockwiseFromNorth) {
  const auto layer = [](double east, double north) {
    return layer_of(kLayers, geom::Axes::enu, {5, 5, 1}, {5 + east, 5 + north, 30});
  };
  EXPECT_EQ(layer(0, 1), 0);
  EXPECT_EQ(layer(1, 1.001), 0);
  EXPECT_EQ(layer(1, 0), 1);
  EXPECT_EQ(layer(0, -1), 2);
  EXPECT_EQ(layer(-1, -0.001), 2);
  EXPECT_EQ(layer(-1, 0), 3);
  EXPECT_EQ(layer(-1e-15, 1), 3);
  EXPECT_EQ(layer(0, 0), 0);
  EXPECT_EQ(layer_of(kLayers, geom::Axes::neu, {0, 0, 0}, {0, 1, 0}), 1);
  EXPECT_EQ(layer_of(kLayers, geom::Axes::neu, {0, 0, 0}, {1, 0, 0}), 0);
}

// The way at heights outside of the layer is all before the cruise or all after it.
void expect_cruise(const geom::CollisionScene& scene, const PlanResult& result, const Vec3& from,
                   const Vec3& to) {
  ASSERT_EQ(result.status, PathStatus::found) << result.message;
  ASSERT_TRUE(result.layer);
  const auto [low, high] = *result.layer;
  const geom::Polyline& path = result.path;
  EXPECT_EQ(path.front(), from);
  EXPECT_EQ(path.back(), to);
  for (std::size_t i = 1; i < path.size(); ++i) {
    EXPECT_TRUE(scene.free(path[i - 1], path[i])) << "leg " << i;
  }
  const auto inside = [&](const Vec3& p) { return low <= p.z() && p.z() <= high; };
  const auto first = std::find_if(path.begin(), path.end(), inside);
  const auto last = std::find_if(path.rbegin(), path.rend(), inside).base();
  ASSERT_LT(first, last);
  EXPECT_TRUE(std::all_of(first, last, inside));
}

TEST(LayerPlanner, CruisesInTheLayerOfTheDirection) {
  const auto scene = scene_of({{{15, 15, -1}, {25, 25, 30}}}, kCube, {1, 1, 1});
  Planner whole(scene);
  LayerPlanner planner(scene, whole, kLayers);
  const Vec3 west(2, 20, 2);
  const Vec3 east(38, 20, 3);
  const PlanResult there = planner.plan(west, east);
  expect_cruise(scene, there, west, east);
  EXPECT_EQ(there.layer, std::pair(15.0, 20.0));
  const PlanResult back = planner.plan(east, west);
  expect_cruise(scene, back, east, west);
  EXPECT_EQ(back.layer, std::pair(25.0, 30.0));
  EXPECT_EQ(there.steps.back().name, "layer");
  EXPECT_GE(geom::length(there.path), geom::length(whole.plan(west, east).path));
}

TEST(LayerPlanner, HasNoWayWhereALayerIsClosed) {
  const auto scene = scene_of({{{19, -1, 14}, {21, 41, 22}}}, kCube, {1, 1, 1});
  Planner whole(scene);
  LayerPlanner planner(scene, whole, kLayers);
  const Vec3 west(2, 20, 2);
  const Vec3 east(38, 20, 2);
  const PlanResult closed = planner.plan(west, east);
  EXPECT_EQ(closed.status, PathStatus::unreachable);
  EXPECT_TRUE(closed.path.empty());
  EXPECT_NE(closed.message.find("the layer of 15 to 20 m"), std::string::npos) << closed.message;
  EXPECT_EQ(planner.plan(east, west).status, PathStatus::found);  // above the wall
}

TEST(LayerPlanner, SaysWhichEndIsBlocked) {
  const auto scene = scene_of({{{30, 15, -1}, {39, 25, 5}}}, kCube, {1, 1, 1});
  Planner whole(scene);
  LayerPlanner planner(scene, whole, kLayers);
  EXPECT_EQ(planner.plan({35, 20, 2}, {2, 20, 2}).status, PathStatus::start_blocked);
  EXPECT_EQ(planner.plan({2, 20, 2}, {35, 20, 2}).status, PathStatus::goal_blocked);
  EXPECT_EQ(planner.plan({2, 20, -2}, {2, 30, 2}).status, PathStatus::start_outside);
}

TEST(LayerPlanner, RefusesLayersBeyondTheMap) {
  const auto scene = scene_of({}, kCube, {1, 1, 1});
  Planner whole(scene);
  EXPECT_THROW(LayerPlanner(scene, whole, {-1, 5, 2}), geom::InputError);
  EXPECT_THROW(LayerPlanner(scene, whole, {20, 5, 5}), geom::InputError);
  LayerPlanner(scene, whole, {0, 10, 4});
}

TEST(LayerPlanner, FindsTheSameFromSeveralThreadsInRandomScenes) {
  int found = 0;
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
    const auto scene = random_scene(seed, 120, 40, Vec3(0.5, 0.5, 0.25));
    Planner whole(scene);
    const Layers layers{8, 6, 5};
    LayerPlanner alone(scene, whole, layers);
    LayerPlanner shared(scene, whole, layers);
    support::Random random(seed);
    std::vector<std::pair<Vec3, Vec3>> queries(40);
    for (auto& [from, to] : queries) {
      for (Vec3* end : {&from, &to}) {
        *end = {random.uniform(1, 39), random.uniform(1, 39), random.uniform(1, 39)};
      }
    }
    std::vector<PlanResult> results(queries.size());
    geom::parallel_for(queries.size(), {4}, [&](std::size_t i) {
      results[i] = shared.plan(queries[i].first, queries[i].second);
    });
    for (std::size_t i = 0; i < queries.size(); ++i) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << " query " << i);
      const auto& [from, to] = queries[i];
      EXPECT_EQ(results[i].path, alone.plan(from, to).path);
      if (results[i].path.empty()) continue;
      ++found;
      expect_cruise(scene, results[i], from, to);
    }
  }
  EXPECT_GT(found, 80);
}

}  // namespace
}  // namespace plan
