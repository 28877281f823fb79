#include "solve/optimize.h"

#include <gtest/gtest.h>

#include <thread>

#include "curve/bernstein.h"
#include "traj/scenes.h"

namespace traj {
namespace {

Corridor straight(double length) {
  return pieces_between(joints({Vec3::Zero(), Vec3(length, 0, 0)}));
}

TEST(Optimize, FliesAStraightLineNearlyAsFastAsTheLimitsAllow) {
  OptimizeOptions options{{{Limit::speed, 8}, {Limit::acceleration, 6}}, 1e-5, 200};
  const OptimizeResult result = optimize(straight(200), options);
  EXPECT_LT(result.max_violation, 1e-4);
  EXPECT_GT(result.iterations, 0);
  const double least = 200 / 8.0 + 8 / 6.0;
  EXPECT_GT(duration(result.trajectory), least);
  EXPECT_LT(duration(result.trajectory), 1.03 * least);
  EXPECT_NEAR(result.objective, duration(result.trajectory) + 1e-5 * snap_cost(result.trajectory),
              1e-9);
}

// A level flight that began at the speed of climbing took three times the iterations.
TEST(Optimize, StartsALevelFlightAtItsHorizontalSpeed) {
  OptimizeOptions one{{{Limit::speed, 15}, {Limit::acceleration, 3}}, 1e-3, 200};
  one.optimizer = Optimizer::banded;
  OptimizeOptions two = one;
  two.limits = {
      {Limit::horizontal_speed, 15}, {Limit::vertical_speed, 3}, {Limit::acceleration, 3}};
  const Corridor corridor = straight(1500);
  const OptimizeResult plain = optimize(corridor, one);
  const OptimizeResult mixed = optimize(corridor, two);
  EXPECT_TRUE(mixed.settled);
  EXPECT_NEAR(duration(mixed.trajectory), duration(plain.trajectory), 0.1);
  EXPECT_LT(mixed.iterations, 2 * plain.iterations);
}

TEST(Optimize, TradesDurationForSnap) {
  const Corridor corridor = straight(100);
  const auto fast =
      optimize(corridor, {{{Limit::speed, 8}, {Limit::acceleration, 6}}, 1e-5, 200}).trajectory;
  const auto smooth =
      optimize(corridor, {{{Limit::speed, 8}, {Limit::acceleration, 6}}, 1e-1, 200}).trajectory;
  EXPECT_LT(duration(fast), duration(smooth));
  EXPECT_GT(snap_cost(fast), 10 * snap_cost(smooth));
}

TEST(Optimize, StaysBehindItsPlanes) {
  const geom::Polyline path{Vec3::Zero(), Vec3(30, 0, 0), Vec3(30, 30, 0)};
  Corridor corridor = pieces_between(joints(path));
  for (CorridorPiece& piece : corridor) piece.planes.push_back({Vec3::UnitX(), 30.2});
  for (CorridorPiece& piece : corridor) piece.planes.push_back({-Vec3::UnitY(), 0.2});
  const OptimizeResult result = optimize(
      corridor, {{{Limit::speed, 8}, {Limit::acceleration, 6}, {Limit::jerk, 60}}, 1e-3, 200});
  EXPECT_LT(result.max_violation, 1e-4);
  for (const Segment& s : result.trajectory.segments) {
    for (const Vec3& p : s.point) {
      EXPECT_LT(p.x(), 30.2 + 1e-4);
      EXPECT_GT(p.y(), -0.2 - 1e-4);
    }
    for (const Vec3& v : velocity_points(s)) EXPECT_LT(v.norm(), 8 + 1e-3);
    for (const Vec3& a : acceleration_points(s)) EXPECT_LT(a.norm(), 6 + 1e-3);
    for (const Vec3& j : jerk_points(s)) EXPECT_LT(j.norm(), 60 + 1e-2);
  }
}

TEST(Optimize, GivesTheSameBytesAgainAndFromManyThreadsAtOnce) {
  const Corridor corridor = straight(60);
  const OptimizeOptions options{{{Limit::speed, 8}, {Limit::acceleration, 6}}, 1e-3, 200};
  const OptimizeResult once = optimize(corridor, options);
  std::vector<OptimizeResult> again(4);
  std::vector<std::thread> threads;
  for (OptimizeResult& r : again) threads.emplace_back([&] { r = optimize(corridor, options); });
  for (std::thread& t : threads) t.join();
  for (const OptimizeResult& r : again) {
    ASSERT_EQ(r.trajectory.segments.size(), once.trajectory.segments.size());
    for (std::size_t i = 0; i < r.trajectory.segments.size(); ++i) {
      EXPECT_EQ(r.trajectory.segments[i].point, once.trajectory.segments[i].point);
      EXPECT_EQ(r.trajectory.segments[i].duration, once.trajectory.segments[i].duration);
    }
  }
}

TEST(Optimize, PrintsNothing) {
  ::testing::internal::CaptureStdout();
  optimize(straight(30), {{{Limit::speed, 8}, {Limit::acceleration, 6}}, 1e-3, 50});
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
}

TEST(Optimize, WithoutIterationsReturnsItsGuess) {
  const OptimizeResult result =
      optimize(straight(30), {{{Limit::speed, 8}, {Limit::acceleration, 6}}, 1e-3, 0});
  EXPECT_EQ(result.status, "iteration limit");
  EXPECT_EQ(result.trajectory.segments.size(), straight(30).size());
}

}  // namespace
}  // namespace traj
