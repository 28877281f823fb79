#include "plan/planner/plan.h"

#include <gtest/gtest.h>

#include "plan/planner/shortcut.h"
#include "plan/planner/snap_end.h"
#include "support/exact_oracle.h"
#include "support/random_city.h"

namespace plan {
namespace {

using geom::CollisionScene;

// A wall across the whole of the bounds, with a hole.
geom::BoxMap walled(bool with_hole) {
  geom::BoxMapSpec spec;
  spec.bounds = {{0, 0, 0}, {100, 60, 40}};
  std::vector<geom::Aabb> boxes = {{{48, 0, 0}, {52, 26, 40}}, {{48, 34, 0}, {52, 60, 40}}};
  if (!with_hole) boxes.push_back({{48, 26, 0}, {52, 34, 40}});
  return geom::BoxMap(spec, support::table_of(boxes));
}

PlanResult plan_in(const geom::BoxMap& map, const Vec3& from, const Vec3& to,
                   PlanOptions options = {}) {
  const CollisionScene scene(map, {"box", {1, 1, 1}}, 0);
  Planner planner(scene, nullptr);
  return planner.plan(from, to, options);
}

TEST(Plan, GoesStraightWhereItCan) {
  const PlanResult result = plan_in(walled(true), {10, 30, 10}, {90, 30, 10});
  EXPECT_EQ(result.status, PathStatus::found);
  EXPECT_EQ(result.route, Route::straight);
  EXPECT_EQ(result.path.size(), 2u);
}

TEST(Plan, FindsTheHoleAndEveryLegIsFree) {
  const CollisionScene scene(walled(true), {"box", {1, 1, 1}}, 0);
  const PlanResult result = plan_in(walled(true), {10, 5, 10}, {90, 5, 10}, {.resample = 5});
  ASSERT_EQ(result.status, PathStatus::found);
  EXPECT_EQ(result.path.front(), Vec3(10, 5, 10));
  EXPECT_EQ(result.path.back(), Vec3(90, 5, 10));
  EXPECT_LT(geom::length(result.path), 95);
  for (std::size_t i = 1; i < result.path.size(); ++i) {
    EXPECT_LE((result.path[i] - result.path[i - 1]).norm(), 5 + 1e-9);
    for (const geom::Aabb& box : scene.map().boxes()) {
      EXPECT_FALSE(oracle::segment_hits(result.path[i - 1], result.path[i], box, scene.half()));
    }
  }
}

TEST(Plan, SaysWhyNot) {
  EXPECT_EQ(plan_in(walled(false), {10, 5, 10}, {90, 5, 10}).status, PathStatus::unreachable);
  EXPECT_EQ(plan_in(walled(true), {50, 5, 10}, {90, 5, 10}).status, PathStatus::start_blocked);
  EXPECT_EQ(plan_in(walled(true), {10, 5, 10}, {50, 5, 10}).status, PathStatus::goal_blocked);
  EXPECT_EQ(plan_in(walled(true), {-10, 5, 10}, {50, 5, 10}).status, PathStatus::start_outside);
  const PlanResult outside = plan_in(walled(true), {10, 5, 10}, {99.5, 5, 10});
  EXPECT_EQ(outside.status, PathStatus::goal_outside);
  EXPECT_NE(outside.message.find("the nearest free point is 0.500 m away"), std::string::npos)
      << outside.message;
}

TEST(Plan, SnapsEndsWhenAskedAndRecordsIt) {
  const PlanResult result = plan_in(walled(true), {47.5, 5, 10}, {90, 5, 10}, {.snap_ends = 1});
  ASSERT_EQ(result.status, PathStatus::found);
  ASSERT_TRUE(result.snapped_start);
  EXPECT_FALSE(result.snapped_goal);
  EXPECT_NEAR(result.snapped_start->x(), 46.999, 1e-6);
  EXPECT_EQ(result.path.front(), *result.snapped_start);
}

TEST(NearestFree, IsCloserThanAnyPointOfAFineGrid) {
  const CollisionScene scene(support::random_city(41, 60, 60), {"box", {1, 1, 1}}, 0);
  support::Random random(42);
  int compared = 0;
  for (int i = 0; i < 40; ++i) {
    const Vec3 p(random.uniform(-25, 25), random.uniform(-25, 25), random.uniform(2, 20));
    const auto found = nearest_free(scene, p, 8);
    if (scene.free(p)) {
      EXPECT_EQ(*found, p);
      continue;
    }
    if (found) {
      ASSERT_TRUE(scene.free(*found));
    }
    const double bound = found ? (*found - p).norm() : 8;
    for (double x = -8; x <= 8; x += 0.5) {
      for (double y = -8; y <= 8; y += 0.5) {
        for (double z = -8; z <= 8; z += 0.5) {
          const Vec3 d(x, y, z);
          if (d.norm() >= bound - 1e-5) continue;
          ASSERT_FALSE(scene.free(p + d)) << "case " << i;
        }
      }
    }
    ++compared;
  }
  EXPECT_GT(compared, 5);
}

TEST(Shortcut, NeverLengthensAndKeepsTheEnds) {
  const CollisionScene scene(support::random_city(43, 80, 120), {"box", {1, 1, 1}}, 0);
  Planner planner(scene, nullptr);
  support::Random random(44);
  int shortened = 0;
  for (int i = 0; i < 60; ++i) {
    const Vec3 a(random.uniform(-60, 60), random.uniform(-60, 60), random.uniform(2, 30));
    const Vec3 b(random.uniform(-60, 60), random.uniform(-60, 60), random.uniform(2, 30));
    const PlanResult raw = planner.plan(a, b, {.raw = true});
    if (raw.status != PathStatus::found || raw.route == Route::straight) continue;
    const geom::Polyline path = shortcut(scene, raw.path);
    EXPECT_LE(geom::length(path), geom::length(raw.path));
    EXPECT_EQ(path.front(), a);
    EXPECT_EQ(path.back(), b);
    for (std::size_t k = 1; k < path.size(); ++k) ASSERT_TRUE(scene.free(path[k - 1], path[k]));
    ++shortened;
  }
  EXPECT_GT(shortened, 5);
}

}  // namespace
}  // namespace plan
