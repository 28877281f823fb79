#include "traj/record/solved_record.h"

#include <gtest/gtest.h>

#include "traj/proof/check.h"
#include "traj/scenes.h"

namespace traj {
namespace {

const Limits kLimits{{Limit::speed, 5}, {Limit::acceleration, 4}};

geom::PathRecord way() {
  geom::PathRecord record{.id = "p1", .status = geom::PathStatus::found};
  record.points = {{0, 5, 5}, {9, 5, 5}};
  return record;
}

TEST(SolveRecord, HasTheTrajectoryAndWhatThePathSays) {
  const auto scene = testing::scene_of({});
  geom::PathRecord path = way();
  path.time.start = 7;
  path.bound = 9;
  path.provenance = geom::provenance_of(scene);
  const TrajectoryRecord record = solve_record(scene, path, {.limits = kLimits}).record;
  EXPECT_EQ(record.id, "p1");
  ASSERT_EQ(record.status, TrajectoryStatus::solved);
  EXPECT_TRUE(check(scene, record.trajectory, kLimits).ok);
  EXPECT_EQ(record.time.start, 7);
  EXPECT_EQ(record.bound, 9);
  EXPECT_TRUE(record.duration_bound);
  EXPECT_FALSE(record.trajectory.segments[0].yaw);
}

TEST(SolveRecord, StandsStillWhereThePathHolds) {
  const auto scene = testing::scene_of({});
  geom::PathRecord path = way();
  const double moving = duration(solve_record(scene, path, {.limits = kLimits}).record.trajectory);
  path.hold = {0, 3};
  EXPECT_NEAR(duration(solve_record(scene, path, {.limits = kLimits}).record.trajectory),
              moving + 3, 1e-9);
}

TEST(SolveRecord, AddsAYawIfAsked) {
  const auto scene = testing::scene_of({});
  const YawOptions yaw{.rate = 1};
  EXPECT_TRUE(
      solve_record(scene, way(), {.limits = kLimits}, yaw).record.trajectory.segments[0].yaw);
}

TEST(SolveRecord, OfAPathThatWasNotFoundSaysWhy) {
  const auto scene = testing::scene_of({});
  geom::PathRecord lost{.id = "p1", .status = geom::PathStatus::unreachable};
  const TrajectoryRecord record = solve_record(scene, lost, {.limits = kLimits}).record;
  EXPECT_EQ(record.status, TrajectoryStatus::no_path);
  EXPECT_EQ(record.message, "unreachable");
  EXPECT_EQ(record.limits[Limit::speed], 5);
  lost.message = "walled in";
  EXPECT_EQ(without_path(lost, {}).message, "walled in");
}

}  // namespace
}  // namespace traj
