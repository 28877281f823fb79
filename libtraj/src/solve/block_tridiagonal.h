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

 private:
  static constexpr int kHalf = (kSize + 3) / 4 * 4;  // rows of a block in memory, of whole lanes
  static constexpr int kRows = 2 * kHalf;            // a column has the diagonal's block, and below
  static constexpr std::size_t kBlock = kSize * kRows;

 public:
  using Block =
      Eigen::Map<Eigen::Matrix<double, kSize, kSize>, Eigen::Unaligned, Eigen::OuterStride<kRows>>;

  explicit BlockTridiagonal(std::size_t blocks) : size_(blocks), columns_(blocks * kBlock) {}

  // Of the blocks on the diagonal the lower triangles count.
  Block diagonal(std::size_t i) { return Block(&columns_[i * kBlock]); }
  Block below(std::size_t i) {
    return Block(&columns_[i * kBlock + kHalf]);
  }  // row i + 1, column i

  // Cholesky, in place, by blocks (Golub and Van Loan, Matrix Computations, 4.5.1). False where the
  // matrix is not positive definite to rounding; then what is left is of no use.
  bool factor();

  // Solves in place, once it is factored: kSize numbers a block.
  void solve(std::span<double> b) const;

 private:
  std::size_t size_;
  std::vector<double> columns_;
};

}  // namespace traj
