#pragma once

// Symmetric positive definite matrices of blocks on three diagonals.

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "nlp.h"

namespace traj {

class BlockTridiagonal {
 public:
  static constexpr int kSize = Nlp::kPiece;  // a block for each piece of the optimiser's problem
  using Block = Eigen::Matrix<double, kSize, kSize>;

  explicit BlockTridiagonal(std::size_t blocks)
      : diagonal_(blocks, Block::Zero()), below_(blocks - 1, Block::Zero()) {}

  void set_zero() {
    for (Block& b : diagonal_) b.setZero();
    for (Block& b : below_) b.setZero();
  }
  Block& diagonal(std::size_t i) { return diagonal_[i]; }
  Block& below(std::size_t i) { return below_[i]; }  // row i + 1, column i

  // Cholesky, in place, by blocks (Golub and Van Loan, Matrix Computations, 4.5.1). False where the
  // matrix is not positive definite to rounding; then what is left is of no use.
  bool factor();

  // Solves in place, once it is factored: kSize numbers a block.
  void solve(std::span<double> b) const;

 private:
  std::vector<Block> diagonal_;
  std::vector<Block> below_;
};

}  // namespace traj
