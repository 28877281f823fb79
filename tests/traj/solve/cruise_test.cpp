// libtraj/src/solve/cruise.h

#include "solve/cruise.h"

#include <gtest/gtest.h>

#include "curve/bernstein.h"
#include "solve/optimize.h"
#include "traj/proof/check.h"
#include "traj/scenes.h"
#include "traj/solve/solve.h"

namespace traj {
namespace {

const Limits kLimits{
    {Limit::horizontal_speed, 10}, {Limit::vertical_speed, 4}, {Limit::acceleration, 3}};

Corridor along(const geom::Polyline& path) { return pieces_between(joints(path)); }

// One after another, from the first piece to the last, and never a single piece between cruises.
void expect_whole(const std::vector<CruisePart>& all, const Corridor& corridor) {
  std::size_t at = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(all[i].first, at);
    EXPECT_EQ(all[i].cruises(), i % 2 == 1);
    EXPECT_GE(all[i].last, at + (all[i].cruises() ? 1 : 2));
    at = all[i].last;
  }
  EXPECT_EQ(at, corridor.size());
  EXPECT_EQ(all.size() % 2, 1u) << "begins and ends with what is optimised";
}

TEST(Stretches, CruiseInTheMiddleOfLongLegs) {
  const Corridor corridor =
      along({Vec3::Zero(), Vec3(900, 0, 0), Vec3(900, 60, 0), Vec3(0, 60, 90)});
  const auto all = cruise_parts(corridor, kLimits, 1e-3);
  expect_whole(all, corridor);
  ASSERT_EQ(all.size(), 5u) << "60 m are too few";
  EXPECT_EQ(all[1].velocity, Vec3(10, 0, 0));
  EXPECT_NEAR(all[3].velocity.head<2>().norm(), 10, 1e-12);
  EXPECT_NEAR(all[3].velocity.z(), 1, 1e-12) << "90 m up on 900 m";
  // From rest to 10 m/s in 17 m, and three times a second and more.
  EXPECT_GE(corridor[all[1].first].from.x(), 10 * 10 / 6.0 + 30);
  EXPECT_LE(corridor[all[1].last].from.x(), 900 - (10 * 10 / 6.0 + 30));
}

TEST(Stretches, AreOneWhereTheLegIsShortOrItsSpeedOpen) {
  EXPECT_EQ(cruise_parts(along({Vec3::Zero(), Vec3(90, 0, 0)}), kLimits, 1e-3).size(), 1u);
  const Corridor far = along({Vec3::Zero(), Vec3(9000, 0, 0)});
  EXPECT_EQ(cruise_parts(far, {{Limit::acceleration, 3}}, 1e-3).size(), 1u);
  EXPECT_EQ(cruise_parts(far, {{Limit::vertical_speed, 3}, {Limit::acceleration, 3}}, 1e-3).size(),
            1u);
  EXPECT_EQ(cruise_parts(far, {{Limit::speed, 10}}, 1e-3).size(), 1u) << "no acceleration is given";
  EXPECT_EQ(cruise_parts(far, kLimits, 1e-3).size(), 3u);
}

TEST(Stretches, AreTheSameFarFromTheOrigin) {
  const Vec3 far(500000, 5400000, 0);
  const geom::Polyline path{Vec3::Zero(), Vec3(701, 311, 13), Vec3(900, -800, 20)};
  geom::Polyline moved = path;
  for (Vec3& p : moved) p += far;
  const auto here = cruise_parts(along(path), kLimits, 1e-3);
  const auto there = cruise_parts(along(moved), kLimits, 1e-3);
  ASSERT_EQ(here.size(), 5u);
  ASSERT_EQ(there.size(), here.size());
  for (std::size_t i = 0; i < here.size(); ++i) EXPECT_EQ(there[i].first, here[i].first);
}

TEST(Cruise, IsExactlyStraightFromEndToEndOfItsPieces) {
  const Corridor corridor = along({Vec3::Zero(), Vec3(300, 400, 50)});
  const auto all = cruise_parts(corridor, kLimits, 1e-3);
  ASSERT_EQ(all.size(), 3u);
  const auto pieces = all[1].of(corridor);
  const Trajectory curve = cruise(pieces, all[1].velocity);
  ASSERT_EQ(curve.segments.size(), pieces.size());
  EXPECT_EQ(curve.segments.front().point.front(), pieces.front().from);
  EXPECT_EQ(curve.segments.back().point.back(), pieces.back().to);
  for (const Segment& s : curve.segments) {
    for (const Vec3& v : velocity_points(s)) EXPECT_LT((v - all[1].velocity).norm(), 1e-9);
  }
}

// Beside all of it in one, to a thousandth: on a straight leg, where no corner can be cut.
TEST(Cruise, TakesNoLongerThanAllInOne) {
  for (const double rho : {1e-5, 1e-3, 1e-1}) {
    const Corridor corridor = along({Vec3::Zero(), Vec3(1200, 90, 30)});
    OptimizeOptions options{kLimits, rho, 200, Optimizer::banded};
    const OptimizeResult parts = optimize(corridor, options);
    options.cruise = false;
    const OptimizeResult one = optimize(corridor, options);
    EXPECT_TRUE(parts.settled) << rho;
    EXPECT_TRUE(one.settled) << rho;
    EXPECT_LT(parts.objective, 1.001 * one.objective) << rho;
    EXPECT_LT(parts.max_violation, 1e-4);
    ASSERT_EQ(parts.trajectory.segments.size(), corridor.size());
  }
}

TEST(Cruise, IsProvedWithWhatIsBesideIt) {
  const geom::Aabb bounds{Vec3(-50, -50, 0), Vec3(1250, 450, 60)};
  const geom::CollisionScene scene =
      testing::scene_of({{Vec3(580, -20, 0), Vec3(620, 20, 50)}}, bounds);
  SolveOptions options;
  options.limits = kLimits;
  const geom::Polyline path{Vec3(0, 0, 2), Vec3(600, 22, 20), Vec3(1200, 0, 2)};
  const SolveResult result = solve(scene, path, options);
  ASSERT_EQ(result.status, SolveStatus::solved) << result.reason;
  EXPECT_EQ(result.rung, Rung::banded);
  EXPECT_EQ(result.rounds, 1);
  EXPECT_TRUE(check(scene, result.trajectory, kLimits).ok);
  EXPECT_EQ(result.trajectory.segments.front().point.front(), path.front());
  EXPECT_EQ(result.trajectory.segments.back().point.back(), path.back());
}

// Beside the cruise of this climb the banded optimiser ends with a step too small.
TEST(Cruise, GivesWayWhereAPartBesideItDoesNotSettle) {
  const geom::Aabb bounds{Vec3(-50, -50, 0), Vec3(50, 50, 150)};
  const geom::CollisionScene scene =
      testing::scene_of({{Vec3(30, 30, 0), Vec3(40, 40, 50)}}, bounds);
  const geom::Polyline climb{Vec3(0, 0, 10), Vec3(0, 0, 75.130578512195029),
                             Vec3(0, 0, 132.11742781556626)};
  SolveOptions options;
  options.limits = {{Limit::speed, 2.5984893880977507},
                    {Limit::tilt, 0.43493255321780971},
                    {Limit::thrust, 19.432771017442068}};
  for (const Solver solver : {Solver::automatic, Solver::banded}) {
    options.solver = solver;
    const SolveResult result = solve(scene, climb, options);
    ASSERT_EQ(result.status, SolveStatus::solved) << result.reason;
    EXPECT_EQ(result.rung, Rung::banded);
    EXPECT_LT(duration(result.trajectory), 60) << "122 m at 2.6 m/s";
  }
}

}  // namespace
}  // namespace traj
