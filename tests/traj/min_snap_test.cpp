#include "traj/min_snap.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "scenes.h"
#include "traj/bernstein.h"

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

// d-th derivative of u^k at u, per segment time u = t / T.
double power_derivative(int k, int d, double u) {
  double c = 1;
  for (int i = 0; i < d; ++i) c *= k - i;
  return k < d ? 0 : c * std::pow(u, k - d);
}

// The textbook: 8 coefficients a leg, waypoints, rest ends, and derivatives 1 to 6 continuous, in
// one dense matrix.
std::vector<std::array<Vec3, 8>> dense(const Problem& p) {
  const int n = static_cast<int>(p.times.size());
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(8 * n, 8 * n);
  Eigen::MatrixXd b = Eigen::MatrixXd::Zero(8 * n, 3);
  int row = 0;
  const auto put = [&](int leg, int d, double u, double sign) {
    const double scale = std::pow(p.times[static_cast<std::size_t>(leg)], -d);
    for (int k = 0; k < 8; ++k) a(row, 8 * leg + k) += sign * scale * power_derivative(k, d, u);
  };
  for (int leg = 0; leg < n; ++leg) {
    put(leg, 0, 0, 1);
    b.row(row++) = p.points[static_cast<std::size_t>(leg)].transpose();
    put(leg, 0, 1, 1);
    b.row(row++) = p.points[static_cast<std::size_t>(leg) + 1].transpose();
  }
  for (int d = 1; d <= 3; ++d) {
    put(0, d, 0, 1);
    ++row;
    put(n - 1, d, 1, 1);
    ++row;
  }
  for (int leg = 0; leg + 1 < n; ++leg) {
    for (int d = 1; d <= 6; ++d) {
      put(leg, d, 1, 1);
      put(leg + 1, d, 0, -1);
      ++row;
    }
  }
  const Eigen::MatrixXd x = a.fullPivLu().solve(b);
  std::vector<std::array<Vec3, 8>> out(static_cast<std::size_t>(n));
  for (int leg = 0; leg < n; ++leg) {
    for (int k = 0; k < 8; ++k) {
      out[static_cast<std::size_t>(leg)][static_cast<std::size_t>(k)] = x.row(8 * leg + k);
    }
  }
  return out;
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
    const auto want = dense(p);
    for (std::size_t leg = 0; leg < want.size(); ++leg) {
      for (const double u : {0.0, 0.3, 0.5, 0.9, 1.0}) {
        Vec3 position = Vec3::Zero();
        for (int k = 0; k < 8; ++k)
          position += want[leg][static_cast<std::size_t>(k)] * std::pow(u, k);
        const Vec3 here = evaluate(got.segments[leg], u * p.times[leg]).position;
        EXPECT_LT((here - position).norm(), 1e-7 * (1 + position.norm())) << "seed " << seed;
      }
    }
  }
}

TEST(MinSnap, IsContinuousToTheSixthDerivative) {
  const Problem p = random_problem(12, 7);
  const Trajectory t = min_snap(p.points, p.times);
  for (std::size_t i = 0; i + 1 < t.segments.size(); ++i) {
    for (int d = 0; d <= 6; ++d) {
      const Vec3 before = derivative_at(t.segments[i], d, true);
      const Vec3 after = derivative_at(t.segments[i + 1], d, false);
      EXPECT_LT((before - after).norm(), 1e-7 * (1 + before.norm())) << "joint " << i << " d " << d;
    }
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

TEST(MinSnap, CostsLessThanAnyPerturbation) {
  const Problem p = random_problem(5, 9);
  const Trajectory best = min_snap(p.points, p.times);
  testing::Random random(10);
  for (int i = 0; i < 20; ++i) {
    State s = evaluate(best.segments[1], best.segments[1].duration);
    s.velocity += random.vector(0.1);
    s.jerk += random.vector(0.1);
    Trajectory other = best;
    const State before = evaluate(best.segments[1], 0);
    const State after = evaluate(best.segments[2], best.segments[2].duration);
    other.segments[1] = hermite(before, s, p.times[1]);
    other.segments[2] = hermite(s, after, p.times[2]);
    EXPECT_LT(snap_cost(best), snap_cost(other));
  }
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
