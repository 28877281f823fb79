// libtraj/src/solve/banded_solve.h: optimality against finite differences, agreement with Ipopt,
// and problems that have no answer.

#include "solve/banded_solve.h"

#include <gtest/gtest.h>

#include <cmath>

#include "solve/optimize.h"
#include "traj/scenes.h"

namespace traj {
namespace {

const Limits kLimits{{Limit::speed, 8}, {Limit::acceleration, 6}};

// A walk with legs of 4 to 30 m, and walls beside it.
Corridor random_corridor(testing::Random& random) {
  geom::Polyline path{Vec3::Zero()};
  for (int i = 0; i < 4; ++i) {
    path.push_back(path.back() + random.number(4, 30) * random.vector(1).normalized());
  }
  Corridor corridor = pieces_between(joints(path));
  for (CorridorPiece& piece : corridor) {
    for (int i = 0; i < 3; ++i) {
      const Vec3 normal = random.vector(1).normalized();
      const double most = std::max(normal.dot(piece.from), normal.dot(piece.to));
      piece.planes.push_back({normal, most + random.number(0.2, 3)});
    }
  }
  return corridor;
}

OptimizeResult with(Optimizer optimizer, const Corridor& corridor, const Limits& limits,
                    int iterations = 300) {
  return optimize(corridor, {limits, 1e-3, iterations, optimizer});
}

// Turns and walls like no path's: now and then it does not settle (then Ipopt follows), and it may
// end in another optimum.
TEST(BandedSolve, AgreesWithIpoptWhereItSettles) {
  testing::Random random(1);
  double banded_sum = 0;
  double ipopt_sum = 0;
  int settled = 0;
  for (int c = 0; c < 20; ++c) {
    const Corridor corridor = random_corridor(random);
    Limits limits = kLimits;
    if (c % 2 == 1) limits[Limit::jerk] = 30;
    if (c % 4 >= 2) limits[Limit::tilt] = 0.5;
    const OptimizeResult banded = with(Optimizer::banded, corridor, limits);
    const OptimizeResult ipopt = with(Optimizer::ipopt, corridor, limits);
    if (!banded.settled) continue;
    ++settled;
    EXPECT_LT(banded.max_violation, 1.1e-4) << c;
    EXPECT_LT(banded.objective, 1.03 * ipopt.objective) << c;
    banded_sum += banded.objective;
    ipopt_sum += ipopt.objective;
  }
  EXPECT_GE(settled, 17);
  EXPECT_LT(banded_sum, 1.005 * ipopt_sum);
}

NlpSpec straight_problem(double length) {
  NlpSpec spec;
  spec.corridor = pieces_between(
      {Vec3::Zero(), Vec3(length / 3, 0, 0), Vec3(2 * length / 3, 0, 0), Vec3(length, 0, 0)});
  spec.limits = {{1, Vec3::Constant(1.0 / 64)}, {2, Vec3::Constant(1.0 / 36)}};
  spec.rho = 1e-2;
  for (int i = 0; i <= 3; ++i) {
    State state{Vec3(length / 3 * i, 0, 0)};
    if (i == 1 || i == 2) state.velocity = Vec3(3, 0, 0);
    spec.state.push_back(state);
    spec.scale.push_back({1, 4, 4, 10});
  }
  spec.time = {4, 4, 4};
  return spec;
}

// Where nothing binds, the gradient is zero: by finite differences, along each variable.
TEST(BandedSolve, EndsWhereTheObjectiveIsFlat) {
  NlpSpec spec = straight_problem(30);
  spec.limits = {{1, Vec3::Constant(1e-6)}};
  spec.rho = 1;
  const Nlp nlp(spec);
  const BandedOutcome outcome = banded_solve(nlp, 500);
  EXPECT_TRUE(outcome.settled) << outcome.status;
  for (std::size_t i = 0; i < outcome.x.size(); ++i) {
    std::vector<double> plus = outcome.x;
    std::vector<double> minus = outcome.x;
    plus[i] += 1e-5;
    minus[i] -= 1e-5;
    EXPECT_NEAR((nlp.objective(plus) - nlp.objective(minus)) / 2e-5, 0, 0.05) << i;
  }
}

// A gain to first order that breaks no binding constraint would show that it stopped too early.
TEST(BandedSolve, LeavesNoFeasibleStepThatGainsMuch) {
  testing::Random random(2);
  const Nlp nlp(straight_problem(60));
  const BandedOutcome outcome = banded_solve(nlp, 500);
  ASSERT_TRUE(outcome.settled) << outcome.status;
  const double best = nlp.objective(outcome.x);
  for (int c = 0; c < 2000; ++c) {
    std::vector<double> x = outcome.x;
    for (double& v : x) v += random.number(-0.02, 0.02);
    const std::vector<double> values = nlp.constraint_values(x);
    bool feasible = true;
    for (std::size_t r = 0; r < values.size(); ++r) {
      feasible = feasible && values[r] <= nlp.bound()[r] + 1e-4;
    }
    if (!feasible) continue;
    EXPECT_GT(nlp.objective(x), best * (1 - 1e-3)) << c;
  }
}

TEST(BandedSolve, WithoutIterationsReturnsTheStart) {
  const Nlp nlp(straight_problem(30));
  const BandedOutcome outcome = banded_solve(nlp, 0);
  EXPECT_EQ(outcome.x, nlp.start());
  EXPECT_EQ(outcome.status, "iteration limit");
  EXPECT_FALSE(outcome.settled);
}

TEST(BandedSolve, StopsAtTheIterationLimit) {
  const BandedOutcome outcome = banded_solve(Nlp(straight_problem(30)), 3);
  EXPECT_EQ(outcome.iterations, 3);
  EXPECT_EQ(outcome.status, "iteration limit");
}

// The joints would have to be on both sides of a gap.
TEST(BandedSolve, DoesNotSettleWhereNothingIsFeasible) {
  NlpSpec spec = straight_problem(30);
  for (CorridorPiece& piece : spec.corridor) {
    piece.planes = {{Vec3::UnitY(), -1}, {-Vec3::UnitY(), -1}};
  }
  const BandedOutcome outcome = banded_solve(Nlp(spec), 100);
  EXPECT_FALSE(outcome.settled) << outcome.status;
  for (const double v : outcome.x) EXPECT_TRUE(std::isfinite(v));
}

// A corridor without width: the planes touch the path from both sides.
TEST(BandedSolve, KeepsToACorridorThatIsALine) {
  NlpSpec spec = straight_problem(30);
  for (CorridorPiece& piece : spec.corridor) {
    for (const Vec3& normal : {Vec3(0, 1, 0), Vec3(0, -1, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)}) {
      piece.planes.push_back({normal, 0});
    }
  }
  const Nlp nlp(spec);
  const BandedOutcome outcome = banded_solve(nlp, 300);
  const std::vector<double> values = nlp.constraint_values(outcome.x);
  for (std::size_t r = 0; r < values.size(); ++r) EXPECT_LT(values[r], nlp.bound()[r] + 1e-3);
}

TEST(BandedSolve, TwoPiecesAreEnough) {
  const Corridor corridor = pieces_between({Vec3::Zero(), Vec3(1, 0, 0), Vec3(1, 1, 0)});
  const OptimizeResult result = with(Optimizer::banded, corridor, kLimits);
  EXPECT_TRUE(result.settled) << result.status;
  EXPECT_LT(result.max_violation, 1.1e-4);
}

TEST(BandedSolve, GivesTheSameBytesAgain) {
  testing::Random random(3);
  const Corridor corridor = random_corridor(random);
  const OptimizeResult once = with(Optimizer::banded, corridor, kLimits);
  const OptimizeResult again = with(Optimizer::banded, corridor, kLimits);
  ASSERT_EQ(once.trajectory.segments.size(), again.trajectory.segments.size());
  for (std::size_t i = 0; i < once.trajectory.segments.size(); ++i) {
    EXPECT_EQ(once.trajectory.segments[i].point, again.trajectory.segments[i].point);
    EXPECT_EQ(once.trajectory.segments[i].duration, again.trajectory.segments[i].duration);
  }
}

}  // namespace
}  // namespace traj
