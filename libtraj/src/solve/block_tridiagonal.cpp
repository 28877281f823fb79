#include "block_tridiagonal.h"

#include <algorithm>
#include <cassert>

#include "columns_cholesky.h"

namespace traj {

bool BlockTridiagonal::factor() {
  const auto factored = [&]() SKYWAY_FOUR_LANES {
    for (std::size_t i = 0; i < size_; ++i) {
      double* const block = &columns_[i * kBlock];
      if (!ColumnsCholesky<kSize, kRows>::eliminate(block)) return false;
      if (i + 1 == size_) break;
      // What is left of the next block: less B B', of the rows below.
      for (int j = 0; j < kSize; ++j) {
        double* const column = block + kBlock + j * kRows;
        Four sum[kHalf / 4];
#pragma GCC unroll 4
        for (int v = 0; v < kHalf / 4; ++v) sum[v] = four(column + 4 * v);
        for (int k = 0; k < kSize; ++k) {
          const double* const below = block + k * kRows + kHalf;
          const double share = below[j];
#pragma GCC unroll 4
          for (int v = 0; v < kHalf / 4; ++v) sum[v] -= share * four(below + 4 * v);
        }
#pragma GCC unroll 4
        for (int v = 0; v < kHalf / 4; ++v) four(column + 4 * v) = sum[v];
      }
    }
    return true;
  };
  return with_four_lanes(factored);
}

void BlockTridiagonal::solve(std::span<double> b) const {
  assert(b.size() == kSize * size_);
  const auto solved = [&]() SKYWAY_FOUR_LANES {
    double at[kRows] = {};  // the block's right side, and the next one's
    for (std::size_t i = 0; i < size_; ++i) {
      const double* const block = &columns_[i * kBlock];
      std::copy_n(at + kHalf, kHalf, at);
      for (int k = 0; k < kSize; ++k) at[k] += b[kSize * i + static_cast<std::size_t>(k)];
      std::fill_n(at + kHalf, kHalf, 0.0);
      for (int j = 0; j < kSize; ++j) {
        const double* const column = block + j * kRows;
        const double x = at[j] / column[j];
        b[kSize * i + static_cast<std::size_t>(j)] = x;
        for (int v = j / 4; v < kRows / 4; ++v) four(at + 4 * v) -= x * four(column + 4 * v);
      }
    }
    std::fill_n(at, kRows, 0.0);  // the block's solution, and the next one's
    for (std::size_t i = size_; i-- > 0;) {
      const double* const block = &columns_[i * kBlock];
      std::copy_n(at, kHalf, at + kHalf);
      std::fill_n(at, kHalf, 0.0);
      for (int j = kSize; j-- > 0;) {
        const double* const column = block + j * kRows;
        Four sum = {};
        for (int v = j / 4; v < kRows / 4; ++v) sum += four(column + 4 * v) * four(at + 4 * v);
        double& x = b[kSize * i + static_cast<std::size_t>(j)];
        x = (x - (sum[0] + sum[1] + sum[2] + sum[3])) / column[j];
        at[j] = x;
      }
    }
  };
  with_four_lanes(solved);
}

}  // namespace traj
