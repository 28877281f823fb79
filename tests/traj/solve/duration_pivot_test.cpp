// libtraj/src/solve/duration_pivot.h against Eigen's eigenvalues.

#include "solve/duration_pivot.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "traj/scenes.h"

namespace traj {
namespace {

constexpr int kTime = Nlp::kTime;

// The states' part is positive definite, whatever the duration's is.
Nlp::Block random_block(testing::Random& random) {
  Nlp::Block root;
  for (double& v : root.reshaped()) v = random.number(-1, 1);
  Nlp::Block block = root * root.transpose() + Nlp::Block::Identity();
  block(kTime, kTime) = random.number(-2, 10);
  return block;
}

double least_eigenvalue(const Nlp::Block& block) {
  return Eigen::SelfAdjointEigenSolver<Nlp::Block>(block).eigenvalues().minCoeff();
}

TEST(DurationPivot, IsNegativeWhereTheBlockHasANegativeEigenvalue) {
  testing::Random random(1);
  int negative = 0;
  for (int c = 0; c < 200; ++c) {
    const Nlp::Block block = random_block(random);
    const double least = least_eigenvalue(block);
    if (std::abs(least) < 1e-4) continue;
    EXPECT_EQ(duration_pivot(block) < 0, least < 0) << c;
    negative += least < 0;
  }
  EXPECT_GT(negative, 20);
  EXPECT_LT(negative, 180);
}

TEST(DurationPivot, IsWhatTheDurationNeeds) {
  testing::Random random(2);
  for (int c = 0; c < 50; ++c) {
    Nlp::Block block = random_block(random);
    block(kTime, kTime) -= duration_pivot(block);
    EXPECT_NEAR(least_eigenvalue(block), 0, 1e-4) << c;
  }
}

TEST(DurationPivot, LeavesOutWhatIsFixed) {
  testing::Random random(3);
  Nlp::Block block = random_block(random);
  for (int i = 0; i < kTime; ++i) {
    block.row(i).setZero();
    block.col(i).setZero();
  }
  const double least = duration_pivot(block);
  block(kTime, kTime) -= least;
  for (int i = 0; i < kTime; ++i) block(i, i) = 1;
  EXPECT_NEAR(least_eigenvalue(block), 0, 1e-4);
}

TEST(DurationPivot, IsFiniteWhereTheStatesAreNotBentAtAll) {
  Nlp::Block block = Nlp::Block::Zero();
  EXPECT_EQ(duration_pivot(block), 0);
  block(0, kTime) = block(kTime, 0) = 1;
  EXPECT_LT(duration_pivot(block), 0);
}

}  // namespace
}  // namespace traj
