#include "traj/solve/min_snap.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <Eigen/SparseLU>

#include "curve/bernstein.h"
#include "curve/continuity.h"
#include "support/min_snap_equations.h"
#include "traj/scenes.h"

namespace traj {
namespace {

struct Problem {
  std::vector<Vec3> points;
  std::vector<double> times;
};

Problem random_problem(int legs, unsigned seed) {
  testing::Random random(seed);
  Problem p;
  p.points.push_back(random.vector(50));
  for (int i = 0; i < legs; ++i) {
    p.points.push_back(random.vector(50));
    p.times.push_back(random.number(0.5, 4));
  }
  return p;
}

// The d-th derivative at an end of a segment, d up to 6.
Vec3 derivative_at(const Segment& s, int d, bool end) {
  std::vector<Vec3> q(s.point.begin(), s.point.end());
  for (int i = 0; i < d; ++i) {
    const double degree = static_cast<double>(q.size() - 1);
    for (std::size_t k = 0; k + 1 < q.size(); ++k) q[k] = (q[k + 1] - q[k]) * degree / s.duration;
    q.pop_back();
  }
  return end ? q.back() : q.front();
}

TEST(MinSnap, AgreesWithADenseSolverOnTheInterpolatingSpline) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Problem p = random_problem(2 + static_cast<int>(seed) / 2, seed);
    const Trajectory got = min_snap(p.points, p.times);
    const auto equations = support::min_snap_equations(p.points, p.times);
    const Trajectory want =
        support::trajectory_of(equations.dense().fullPivLu().solve(equations.right), p.times);
    for (std::size_t leg = 0; leg < want.segments.size(); ++leg) {
      for (std::size_t k = 0; k < 8; ++k) {
        const Vec3& expected = want.segments[leg].point[k];
        EXPECT_LT((got.segments[leg].point[k] - expected).norm(), 1e-7 * (1 + expected.norm()))
            << "seed " << seed;
      }
    }
  }
}

TEST(MinSnap, CostsWhatASparseSolverFindsToTenDigits) {
  for (const int legs : {10, 100, 1000, 10000}) {
    const Problem p = random_problem(legs, 12);
    const auto equations = support::min_snap_equations(p.points, p.times);
    Eigen::SparseLU<Eigen::SparseMatrix<double>> lu(equations.sparse());
    ASSERT_EQ(lu.info(), Eigen::Success);
    const double want = snap_cost(support::trajectory_of(lu.solve(equations.right), p.times));
    EXPECT_NEAR(snap_cost(min_snap(p.points, p.times)) / want, 1, 1e-10) << legs;
  }
}

TEST(MinSnap, PassesWaypointsBitForBitAndRestsAtTheEnds) {
  const Problem p = random_problem(30, 8);
  const Trajectory t = min_snap(p.points, p.times);
  for (std::size_t i = 0; i < t.segments.size(); ++i) {
    EXPECT_EQ(t.segments[i].point.front(), p.points[i]);
    EXPECT_EQ(t.segments[i].point.back(), p.points[i + 1]);
    EXPECT_EQ(t.segments[i].duration, p.times[i]);
  }
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(t.segments.front().point[k], p.points.front());
    EXPECT_EQ(t.segments.back().point[7 - k], p.points.back());
  }
}

TEST(MinSnap, BetweenTwoPointsIsTheRestToRestStep) {
  const std::vector<Vec3> points{Vec3(1, 2, 3), Vec3(4, 5, 6)};
  const Trajectory t = min_snap(points, std::vector<double>{2});
  EXPECT_EQ(t.segments[0].point[3], points[0]);
  EXPECT_EQ(t.segments[0].point[4], points[1]);
}

TEST(MinSnap, DropsRepeatedPoints) {
  const std::vector<Vec3> points{Vec3::Zero(), Vec3::Zero(), Vec3(1, 0, 0), Vec3(1, 0, 0),
                                 Vec3(1, 1, 0)};
  const Trajectory t = min_snap(points, std::vector<double>{0, 1, 0, 1});
  ASSERT_EQ(t.segments.size(), 2u);
  EXPECT_EQ(t.segments[1].point.back(), Vec3(1, 1, 0));
}

TEST(MinSnap, OfOnePlaceRestsThere) {
  const std::vector<Vec3> points(3, Vec3(1, 2, 3));
  const Trajectory t = min_snap(points, std::vector<double>{2, 3});
  ASSERT_EQ(t.segments.size(), 1u);
  EXPECT_EQ(t.segments[0].duration, 5);
  EXPECT_EQ(evaluate(t, 2.5).position, Vec3(1, 2, 3));
}

TEST(MinSnap, KeepsItsAccuracyFromMillimetresToKilometresFarFromTheOrigin) {
  const Vec3 far(1e6, -1e6, 100);
  const std::vector<Vec3> points{far, far + Vec3(1e-3, 0, 0), far + Vec3(1000, 0, 0),
                                 far + Vec3(1000, 1, 0), far + Vec3(0, 0, 50)};
  const Trajectory t = min_snap(points, std::vector<double>{0.1, 130, 1, 150});
  for (std::size_t i = 0; i + 1 < t.segments.size(); ++i) {
    for (int d = 0; d <= 3; ++d) {
      const Vec3 before = derivative_at(t.segments[i], d, true);
      const Vec3 after = derivative_at(t.segments[i + 1], d, false);
      EXPECT_LT((before - after).norm(), 1e-3 * (1 + before.norm())) << "joint " << i << " d " << d;
    }
  }
}

TEST(MinSnap, MeetsToRoundingWithLegsOfAMillimetreAndAKilometre) {
  const std::vector<Vec3> points{Vec3::Zero(), Vec3(1e-3, 0, 0), Vec3(1000, 0, 0),
                                 Vec3(1000, 1e-3, 0), Vec3(0, 0, 50)};
  const Trajectory t = min_snap(points, std::vector<double>{0.1, 130, 0.1, 150});
  const auto jumps = largest_jumps(t);
  EXPECT_EQ(jumps[0], 0);
  // An ulp of 1 km is 1e-13 m; a derivative over 0.1 s magnifies it by (7 / 0.1 s) an order.
  EXPECT_LT(jumps[1], 1e-10);
  EXPECT_LT(jumps[2], 1e-8);
  EXPECT_LT(jumps[3], 1e-6);
}

TEST(MinSnap, KeepsGivenStatesAtTheEndsBitForBit) {
  testing::Random random(20);
  std::vector<Waypoint> w = waypoints_at(random_problem(6, 20).points);
  for (Waypoint* end : {&w.front(), &w.back()}) {
    end->velocity = random.vector(3);
    end->acceleration = random.vector(2);
    end->jerk = random.vector(1);
  }
  const std::vector<double> times{1, 2, 0.5, 3, 1, 2};
  const Trajectory t = min_snap(w, times);
  const auto same = [](const State& s, const Waypoint& at) {
    EXPECT_LT((s.position - at.position).norm(), 1e-12);
    EXPECT_LT((s.velocity - *at.velocity).norm(), 1e-9);
    EXPECT_LT((s.acceleration - *at.acceleration).norm(), 1e-9);
    EXPECT_LT((s.jerk - *at.jerk).norm(), 1e-8);
  };
  same(evaluate(t.segments.front(), 0), w.front());
  same(evaluate(t.segments.back(), times.back()), w.back());
  for (const double jump : largest_jumps(t)) EXPECT_LT(jump, 1e-6);
}

TEST(MinSnap, GivenTheStatesOfAnotherSolutionItIsThatSolution) {
  const Problem p = random_problem(5, 21);
  const Trajectory free = min_snap(p.points, p.times);
  std::vector<Waypoint> w = waypoints_at(p.points);
  const State s = evaluate(free.segments[2], 0);
  w[2].velocity = s.velocity;
  w[2].jerk = s.jerk;
  const Trajectory fixed = min_snap(w, p.times);
  for (std::size_t i = 0; i < 5; ++i) {
    for (std::size_t k = 0; k < 8; ++k) {
      EXPECT_LT((fixed.segments[i].point[k] - free.segments[i].point[k]).norm(), 1e-9);
    }
  }
}

TEST(MinSnap, PassesAWaypointAtTheVelocityGivenForTheLeastSnap) {
  const Problem p = random_problem(4, 22);
  std::vector<Waypoint> w = waypoints_at(p.points);
  w[2].velocity = Vec3(1, -2, 0.5);
  const Trajectory best = min_snap(w, p.times);
  EXPECT_LT((evaluate(best.segments[2], 0).velocity - *w[2].velocity).norm(), 1e-12);
  EXPECT_GT(snap_cost(best), snap_cost(min_snap(p.points, p.times)));
  const auto jumps = largest_jumps(best);
  for (std::size_t d = 0; d <= 4; ++d) EXPECT_LT(jumps[d], 1e-7) << d;
  testing::Random random(23);
  for (int i = 0; i < 20; ++i) {
    std::vector<Waypoint> other = w;
    other[2].acceleration = evaluate(best.segments[2], 0).acceleration + random.vector(0.1);
    other[1].jerk = evaluate(best.segments[1], 0).jerk + random.vector(0.1);
    EXPECT_LT(snap_cost(best), snap_cost(min_snap(other, p.times)));
  }
}

TEST(MinSnap, StandsStillWhereItHolds) {
  const Problem p = random_problem(4, 24);
  std::vector<Waypoint> w = waypoints_at(p.points);
  w[2].hold = 3;
  const Trajectory t = min_snap(w, p.times);
  ASSERT_EQ(t.segments.size(), 5u);
  EXPECT_EQ(t.segments[2].duration, 3);
  for (const Vec3& q : t.segments[2].point) EXPECT_EQ(q, p.points[2]);
  const auto jumps = largest_jumps(t);
  for (std::size_t d = 0; d <= 3; ++d) EXPECT_LT(jumps[d], 1e-9) << d;
  // A stop parts the curve: either side is solved as if it were alone.
  const std::span points(p.points);
  const std::span times(p.times);
  const Trajectory before = min_snap(points.first(3), times.first(2));
  EXPECT_LT((before.segments[1].point[2] - t.segments[1].point[2]).norm(), 1e-9);
}

TEST(MinSnap, HoldsAtEitherEndToo) {
  std::vector<Waypoint> w = waypoints_at(std::vector<Vec3>{Vec3::Zero(), Vec3(1, 0, 0)});
  w[0].hold = 2;
  w[1].hold = 1;
  const Trajectory t = min_snap(w, std::vector<double>{3});
  ASSERT_EQ(t.segments.size(), 3u);
  EXPECT_EQ(duration(t), 6);
  EXPECT_EQ(t.segments[0].point[7], Vec3::Zero());
  EXPECT_EQ(t.segments[2].point[0], Vec3(1, 0, 0));
}

TEST(MinSnap, TakesALegOfNoLengthThatTakesTimeAsAPause) {
  const std::vector<Vec3> points{Vec3::Zero(), Vec3(1, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0)};
  const Trajectory t = min_snap(points, std::vector<double>{1, 0.5, 1});
  ASSERT_EQ(t.segments.size(), 3u);
  EXPECT_EQ(t.segments[1].duration, 0.5);
  EXPECT_EQ(evaluate(t, 1.25).velocity, Vec3(0, 0, 0));
}

TEST(MinSnap, SolvesAThousandWaypointsContinuously) {
  const Problem p = random_problem(999, 11);
  const Trajectory t = min_snap(p.points, p.times);
  ASSERT_EQ(t.segments.size(), 999u);
  for (std::size_t i = 0; i + 1 < t.segments.size(); ++i) {
    const Vec3 before = derivative_at(t.segments[i], 6, true);
    const Vec3 after = derivative_at(t.segments[i + 1], 6, false);
    EXPECT_LT((before - after).norm(), 1e-6 * (1 + before.norm())) << "joint " << i;
  }
}

}  // namespace
}  // namespace traj
