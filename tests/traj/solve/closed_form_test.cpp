#include "traj/solve/closed_form.h"

#include <gtest/gtest.h>

#include "curve/continuity.h"
#include "solve/time_scaling.h"
#include "traj/scenes.h"
#include "traj/solve/solve.h"

namespace traj {
namespace {

const std::vector<Vec3> kPath{Vec3(0, 0, 50), Vec3(20, 0, 50), Vec3(20, 10, 50)};
const Limits kLimits{{Limit::speed, 5}, {Limit::acceleration, 2}};

TEST(LegTimes, FollowTheirAllocation) {
  const auto scene = testing::scene_of({});
  const auto times = [&](Times which) { return leg_times(scene, kPath, kLimits, which); };
  EXPECT_EQ(times(Times::distance), (std::vector<double>{20, 10}));
  EXPECT_EQ(times(Times::stops), (std::vector<double>{20 / 5.0 + 2.5, 2 * std::sqrt(5.0)}));
  // Radius 5 m at 2 m/s2: 3.2 m/s, above the cruise of 16/35 of 5 m/s.
  EXPECT_NEAR(times(Times::cautious)[0], 20 / (5 * 16 / 35.0), 1e-12);
  EXPECT_LT(times(Times::trapezoid)[1], 10);
}

TEST(LegTimes, OfCautiousGrowNearObstaclesAndBounds) {
  // Comfortable: 25 / 4 m. A box 2 m beside the first leg, away from the second.
  const auto scene = testing::scene_of({{Vec3(5, -12, 40), Vec3(6, -2, 60)}});
  const auto times = leg_times(scene, kPath, kLimits, Times::cautious);
  EXPECT_NEAR(times[0], 20 / (5 * 16 / 35.0 * 2 / 6.25), 1e-7);
  EXPECT_NEAR(times[1], 10 / (5 * 16 / 35.0), 1e-9);
  const auto room = testing::scene_of({}, {Vec3(-5, -5, 0), Vec3(30, 30, 100)});
  EXPECT_NEAR(leg_times(room, kPath, kLimits, Times::cautious)[0], 20 / (5 * 16 / 35.0 * 5 / 6.25),
              1e-9);
}

TEST(ClosedForm, JustHoldsTheLimitsAndNeverFliesFasterThanDistanceSays) {
  const auto scene = testing::scene_of({});
  const auto path = waypoints_at(kPath);
  for (const Times times : {Times::stops, Times::trapezoid}) {
    const auto curve = closed_form(scene, path, kLimits, times);
    EXPECT_NEAR(smallest_factor(*curve, kLimits), 1, 1e-5);
  }
  EXPECT_EQ(duration(*closed_form(scene, path, kLimits, Times::distance)), 30);
  const auto slow =
      closed_form(scene, path, {{Limit::speed, 5}, {Limit::acceleration, 0.1}}, Times::distance);
  EXPECT_GT(duration(*slow), 30);
}

TEST(ClosedForm, KeepsGivenVelocitiesWithinTheLimits) {
  const auto scene = testing::scene_of({});
  auto path = waypoints_at(kPath);
  path[1].velocity = Vec3(1, 1, 0);
  for (const Times times : {Times::stops, Times::distance, Times::cautious, Times::trapezoid}) {
    const auto curve = closed_form(scene, path, kLimits, times);
    ASSERT_TRUE(curve);
    EXPECT_LT((evaluate(curve->segments[1], 0).velocity - Vec3(1, 1, 0)).norm(), 1e-12);
    EXPECT_LE(smallest_factor(*curve, kLimits), 1);
  }
  path[1].velocity = Vec3(6, 0, 0);
  EXPECT_FALSE(closed_form(scene, path, kLimits, Times::stops));
}

TEST(SolveWithHolds, StandsStillAndIsSolvedInParts) {
  const auto scene = testing::scene_of({});
  auto path = waypoints_at(kPath);
  path[1].hold = 4;
  path[2].hold = 1;
  for (const Solver solver : {Solver::closed, Solver::stop_and_go}) {
    SolveOptions options;
    options.limits = kLimits;
    options.solver = solver;
    const SolveResult result = solve(scene, path, options);
    ASSERT_EQ(result.status, SolveStatus::solved) << result.reason;
    ASSERT_EQ(result.trajectory.segments.size(), 4u);
    EXPECT_EQ(result.trajectory.segments[1].duration, 4);
    EXPECT_EQ(result.trajectory.segments[3].duration, 1);
    EXPECT_LT(largest_jumps(result.trajectory)[3], 1e-9);
  }
}

TEST(SolveWithHolds, HoldsInOnePlaceAlone) {
  const auto scene = testing::scene_of({});
  std::vector<Waypoint> path = waypoints_at(std::vector<Vec3>(2, Vec3(1, 2, 3)));
  path[0].hold = 2;
  path[1].hold = 3;
  SolveOptions options;
  options.limits = kLimits;
  const SolveResult result = solve(scene, path, options);
  ASSERT_EQ(result.status, SolveStatus::solved) << result.reason;
  EXPECT_EQ(duration(result.trajectory), 5);
  EXPECT_EQ(result.rung, Rung::closed);
}

TEST(SolveWithVelocities, TriesTheClosedFormAlone) {
  const auto scene = testing::scene_of({});
  auto path = waypoints_at(kPath);
  path[1].velocity = Vec3(0.5, 0.5, 0);
  SolveOptions options;
  options.limits = kLimits;
  EXPECT_EQ(solve(scene, path, options).rung, Rung::closed);
  options.solver = Solver::stop_and_go;
  EXPECT_EQ(solve(scene, path, options).reason, "only the closed form keeps given velocities");
}

}  // namespace
}  // namespace traj
