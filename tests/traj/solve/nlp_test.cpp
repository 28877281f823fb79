// libtraj/src/solve/nlp.h against finite differences.

#include "solve/nlp.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "traj/scenes.h"

namespace traj {
namespace {

using Vector = std::vector<double>;

Nlp random_problem(testing::Random& random) {
  NlpSpec spec;
  const std::size_t n = 4;
  spec.limits = {{1, Vec3::Constant(1.0 / 64)},
                 {2, Vec3::Constant(1.0 / 36)},
                 {3, Vec3::Constant(1.0 / 400)},
                 {1, Vec3(0.1, 0.1, 0)},
                 {2, Vec3(0.02, 0.02, -0.01), Vec3(0, 0, 9.8), 0}};
  spec.rho = 1e-2;
  for (std::size_t k = 0; k <= n; ++k) {
    const bool end = k == 0 || k == n;
    State s = end ? State{random.vector(20)} : random.state(5);
    if (k == n) s.velocity = Vec3(2, -3, 1);  // fixed, and not at rest
    spec.state.push_back(s);
    spec.scale.push_back({1, random.number(1, 8), random.number(1, 6), random.number(5, 20)});
  }
  for (std::size_t k = 0; k < n; ++k) {
    CorridorPiece piece{spec.state[k].position, spec.state[k + 1].position, {}};
    for (std::size_t i = 0; i < k; ++i) {
      piece.planes.push_back({random.vector(1).normalized(), random.number(-5, 5)});
    }
    piece.planes.push_back({Vec3::UnitZ(), 3});
    spec.corridor.push_back(piece);
    spec.time.push_back(random.number(1, 3));
  }
  return Nlp(spec);
}

// A point near the guess.
Vector perturbed(const Nlp& nlp, testing::Random& random) {
  Vector x = nlp.start();
  for (double& v : x) v += random.number(-0.1, 0.1);
  return x;
}

template <class F>
auto difference(const F& f, const Vector& x, std::size_t i, double h) {
  Vector plus = x;
  Vector minus = x;
  plus[i] += h;
  minus[i] -= h;
  return std::pair{f(plus), f(minus)};
}

TEST(Nlp, GradientMatchesFiniteDifferences) {
  testing::Random random(1);
  for (int c = 0; c < 5; ++c) {
    const Nlp nlp = random_problem(random);
    const Vector x = perturbed(nlp, random);
    const Vector gradient = nlp.gradient(x);
    for (std::size_t i = 0; i < x.size(); ++i) {
      const auto [p, m] = difference([&](const Vector& y) { return nlp.objective(y); }, x, i, 1e-5);
      const double want = (p - m) / 2e-5;
      EXPECT_NEAR(gradient[i], want, 2e-6 * (std::abs(want) + nlp.objective(x))) << c << " " << i;
    }
  }
}

TEST(Nlp, JacobianMatchesFiniteDifferencesAndMissesNoEntry) {
  testing::Random random(2);
  for (int c = 0; c < 5; ++c) {
    const Nlp nlp = random_problem(random);
    const Vector x = perturbed(nlp, random);
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(nlp.constraints(), nlp.variables());
    const Vector values = nlp.jacobian(x);
    ASSERT_EQ(values.size(), nlp.jacobian_entries().size());
    for (std::size_t e = 0; e < values.size(); ++e) {
      const Nlp::Entry entry = nlp.jacobian_entries()[e];
      dense(entry.row, entry.column) += values[e];
    }
    for (int i = 0; i < nlp.variables(); ++i) {
      const auto [p, m] = difference([&](const Vector& y) { return nlp.constraint_values(y); }, x,
                                     static_cast<std::size_t>(i), 1e-5);
      for (int r = 0; r < nlp.constraints(); ++r) {
        const std::size_t row = static_cast<std::size_t>(r);
        const double want = (p[row] - m[row]) / 2e-5;
        EXPECT_NEAR(dense(r, i), want, 1e-6 * (1 + std::abs(want))) << c << " " << r << " " << i;
      }
    }
  }
}

Vector lagrangian_gradient(const Nlp& nlp, const Vector& x, double factor, const Vector& lambda) {
  Vector out = nlp.gradient(x);
  for (double& v : out) v *= factor;
  const Vector jacobian = nlp.jacobian(x);
  for (std::size_t e = 0; e < jacobian.size(); ++e) {
    const Nlp::Entry entry = nlp.jacobian_entries()[e];
    out[static_cast<std::size_t>(entry.column)] +=
        jacobian[e] * lambda[static_cast<std::size_t>(entry.row)];
  }
  return out;
}

Vector multipliers(const Nlp& nlp, testing::Random& random) {
  Vector lambda;
  for (int r = 0; r < nlp.constraints(); ++r) lambda.push_back(random.number(0, 1));
  return lambda;
}

// A symmetric block of which there is the lower triangle.
Nlp::Block whole(const Nlp::Block& lower) { return lower.selfadjointView<Eigen::Lower>(); }

TEST(Nlp, HessianBlocksMatchFiniteDifferencesBeforeTheirEigenvaluesAreTurned) {
  testing::Random random(3);
  for (int c = 0; c < 5; ++c) {
    const Nlp nlp = random_problem(random);
    const Vector x = perturbed(nlp, random);
    const Vector lambda = multipliers(nlp, random);
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(nlp.variables(), nlp.variables());
    for (std::size_t k = 0; k < 4; ++k) {
      const Nlp::Block h = whole(nlp.hessian_block(k, x, 0.7, lambda));
      for (int i = 0; i < Nlp::kLocal; ++i) {
        for (int j = 0; j < Nlp::kLocal; ++j) {
          const int row = nlp.global(k, i);
          const int column = nlp.global(k, j);
          if (row >= 0 && column >= 0) sum(row, column) += h(i, j);
        }
      }
    }
    const double size = sum.cwiseAbs().maxCoeff();
    for (int i = 0; i < nlp.variables(); ++i) {
      const auto [p, m] =
          difference([&](const Vector& y) { return lagrangian_gradient(nlp, y, 0.7, lambda); }, x,
                     static_cast<std::size_t>(i), 1e-5);
      for (int j = 0; j < nlp.variables(); ++j) {
        const std::size_t column = static_cast<std::size_t>(j);
        const double want = (p[column] - m[column]) / 2e-5;
        EXPECT_NEAR(sum(i, j), want, 1e-6 * (size + std::abs(want))) << c << " " << i << " " << j;
      }
    }
  }
}

Eigen::MatrixXd dense_jacobian(const Nlp& nlp, const Vector& x) {
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(nlp.constraints(), nlp.variables());
  const Vector values = nlp.jacobian(x);
  for (std::size_t e = 0; e < values.size(); ++e) {
    const Nlp::Entry entry = nlp.jacobian_entries()[e];
    dense(entry.row, entry.column) += values[e];
  }
  return dense;
}

Eigen::VectorXd random_vector(int size, testing::Random& random) {
  Eigen::VectorXd out(size);
  for (double& v : out) v = random.number(-1, 1);
  return out;
}

TEST(Nlp, ProductsWithTheJacobianAreThoseOfTheDenseOne) {
  testing::Random random(6);
  const Nlp nlp = random_problem(random);
  const Vector x = perturbed(nlp, random);
  const Eigen::MatrixXd dense = dense_jacobian(nlp, x);
  const Eigen::VectorXd d = random_vector(nlp.variables(), random);
  const Eigen::VectorXd v = random_vector(nlp.constraints(), random);
  const auto points = nlp.points(x);
  const Vector along = nlp.jacobian_times(points, {d.data(), static_cast<std::size_t>(d.size())});
  const Vector back =
      nlp.transposed_jacobian_times(points, {v.data(), static_cast<std::size_t>(v.size())});
  EXPECT_TRUE(Eigen::VectorXd::Map(along.data(), v.size()).isApprox(dense * d, 1e-12));
  EXPECT_TRUE(Eigen::VectorXd::Map(back.data(), d.size()).isApprox(dense.transpose() * v, 1e-12));
}

TEST(Nlp, CondensedBlocksAddTheWeightedRows) {
  testing::Random random(7);
  const Nlp nlp = random_problem(random);
  const Vector x = perturbed(nlp, random);
  const Vector lambda = multipliers(nlp, random);
  const Vector weights = multipliers(nlp, random);
  const auto points = nlp.points(x);
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(nlp.variables(), nlp.variables());
  for (std::size_t k = 0; k < nlp.pieces(); ++k) {
    const Nlp::Block added = whole(nlp.condensed_block(k, x, points, 1, lambda, weights) -
                                   nlp.hessian_block(k, x, 1, lambda));
    for (int i = 0; i < Nlp::kLocal; ++i) {
      for (int j = 0; j < Nlp::kLocal; ++j) {
        const int row = nlp.global(k, i);
        const int column = nlp.global(k, j);
        if (row >= 0 && column >= 0) sum(row, column) += added(i, j);
      }
    }
  }
  const Eigen::MatrixXd dense = dense_jacobian(nlp, x);
  const Eigen::VectorXd w = Eigen::VectorXd::Map(weights.data(), nlp.constraints());
  EXPECT_TRUE(sum.isApprox(dense.transpose() * w.asDiagonal() * dense, 1e-10));
}

TEST(Nlp, HessianIsPositiveSemidefinite) {
  testing::Random random(4);
  const Nlp nlp = random_problem(random);
  const Vector x = perturbed(nlp, random);
  const Vector lambda = multipliers(nlp, random);
  const Vector values = nlp.hessian(x, 1, lambda);
  ASSERT_EQ(values.size(), nlp.hessian_entries().size());
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(nlp.variables(), nlp.variables());
  for (std::size_t e = 0; e < values.size(); ++e) {
    const Nlp::Entry entry = nlp.hessian_entries()[e];
    EXPECT_GE(entry.row, entry.column);
    sum(entry.row, entry.column) += values[e];
    if (entry.row != entry.column) sum(entry.column, entry.row) += values[e];
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(sum);
  EXPECT_GT(eigen.eigenvalues().minCoeff(), -1e-9 * eigen.eigenvalues().maxCoeff());
}

TEST(Nlp, TrajectoryIsContinuousToJerkAndBitEqualAtJoints) {
  testing::Random random(5);
  const Nlp nlp = random_problem(random);
  const Trajectory t = nlp.trajectory(perturbed(nlp, random));
  ASSERT_EQ(t.segments.size(), 4u);
  for (std::size_t i = 0; i + 1 < t.segments.size(); ++i) {
    EXPECT_EQ(t.segments[i].point.back(), t.segments[i + 1].point.front());
    const State before = evaluate(t.segments[i], t.segments[i].duration);
    const State after = evaluate(t.segments[i + 1], 0);
    EXPECT_LT((before.velocity - after.velocity).norm(), 1e-11);
    EXPECT_LT((before.jerk - after.jerk).norm(), 1e-8);
  }
}

}  // namespace
}  // namespace traj
