// libtraj/src/solve/block_tridiagonal.h against Eigen's dense LU.

#include "solve/block_tridiagonal.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "traj/scenes.h"

namespace traj {
namespace {

constexpr int kSize = BlockTridiagonal::kSize;
using Block = BlockTridiagonal::Block;

struct Both {
  BlockTridiagonal banded;
  Eigen::MatrixXd dense;
};

// L L' of a random lower block bidiagonal L, so positive definite.
Both random_matrix(std::size_t blocks, testing::Random& random) {
  const auto n = static_cast<Eigen::Index>(blocks) * kSize;
  Eigen::MatrixXd lower = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = std::max<Eigen::Index>(0, (i / kSize - 1) * kSize); j < i; ++j) {
      lower(i, j) = random.number(-1, 1) / kSize;
    }
    lower(i, i) = random.number(0.5, 3);
  }
  Both out{BlockTridiagonal(blocks), lower * lower.transpose()};
  for (std::size_t k = 0; k < blocks; ++k) {
    const auto at = static_cast<Eigen::Index>(k) * kSize;
    out.banded.diagonal(k) = out.dense.block<kSize, kSize>(at, at);
    if (k + 1 < blocks) out.banded.below(k) = out.dense.block<kSize, kSize>(at + kSize, at);
  }
  return out;
}

TEST(BlockTridiagonal, SolvesWhatDenseLuSolves) {
  testing::Random random(1);
  for (const std::size_t blocks : {1u, 2u, 3u, 30u}) {
    Both both = random_matrix(blocks, random);
    Eigen::VectorXd right(both.dense.rows());
    for (double& v : right) v = random.number(-1, 1);
    const Eigen::VectorXd want = both.dense.partialPivLu().solve(right);
    std::vector<double> x(right.begin(), right.end());
    ASSERT_TRUE(both.banded.factor());
    both.banded.solve(x);
    for (std::size_t i = 0; i < x.size(); ++i) {
      EXPECT_NEAR(x[i], want[static_cast<Eigen::Index>(i)], 1e-10 * want.norm()) << blocks;
    }
  }
}

TEST(BlockTridiagonal, RefusesWhatIsNotPositiveDefinite) {
  testing::Random random(2);
  for (const std::size_t wrong : {0u, 3u, 4u}) {
    Both both = random_matrix(5, random);
    both.banded.diagonal(wrong)(7, 7) = -1;
    EXPECT_FALSE(both.banded.factor()) << wrong;
  }
  Both zero{BlockTridiagonal(2), {}};
  EXPECT_FALSE(zero.banded.factor());
}

TEST(BlockTridiagonal, TakesAnotherMatrixOnceItIsFactored) {
  testing::Random random(3);
  Both first = random_matrix(3, random);
  ASSERT_TRUE(first.banded.factor());
  Both second = random_matrix(3, random);
  for (std::size_t k = 0; k < 3; ++k) {
    first.banded.diagonal(k) = second.banded.diagonal(k);
    if (k < 2) first.banded.below(k) = second.banded.below(k);
  }
  std::vector<double> x(3 * kSize, 1.0);
  std::vector<double> want = x;
  ASSERT_TRUE(first.banded.factor() && second.banded.factor());
  first.banded.solve(x);
  second.banded.solve(want);
  EXPECT_EQ(x, want);
}

}  // namespace
}  // namespace traj
