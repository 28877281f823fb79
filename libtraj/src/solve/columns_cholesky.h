#pragma once

// Cholesky of small matrices of a fixed size, in place, by columns of whole lanes.

#include <cmath>
#include <cstddef>
#include <utility>

#include "four_lanes.h"

namespace traj {

// Cholesky of a symmetric matrix, and of rows below it: kColumns columns of kRows numbers, one
// column after the other in memory. The first kColumns rows A become L in the lower triangle, with
// A = L L'; the rows below, B, become B inverse(L'). kRows is a multiple of 4. What stands above
// the diagonal does not matter and is overwritten. Returns false if A is not positive definite to
// rounding; then the numbers are of no use. Left-looking (Golub and Van Loan, Matrix Computations,
// 4.2.5). The same bits with AVX2 and without.
//
//     double a[2 * 4] = {4, 2, 6, 0, 0, 5, 7, 0};         // (4 2; 2 5), and below it (6 7)
//     ColumnsCholesky<2, 4>::eliminate(a);                // a = {2, 1, 3, 0, *, 2, 2, 0}
template <int kColumns, int kRows>
class ColumnsCholesky {
 public:
  static_assert(kRows % 4 == 0 && kRows >= kColumns);

  SKYWAY_FOUR_LANES static bool eliminate(double* a) {
    return eliminate(a, std::make_integer_sequence<int, (kColumns + 3) / 4>());
  }

 private:
  template <int... kPanels>
  SKYWAY_FOUR_LANES static bool eliminate(double* a, std::integer_sequence<int, kPanels...>) {
    return (panel<kPanels>(a) && ...);
  }

  // Four columns, from the lanes on that their diagonal is in.
  template <int kPanel>
  SKYWAY_FOUR_LANES static bool panel(double* a) {
    constexpr int kFirst = 4 * kPanel;
    constexpr int kLast = kFirst + 4 < kColumns ? kFirst + 4 : kColumns;
    constexpr int kLanes = kRows / 4 - kPanel;
    for (int j = kFirst; j < kLast; ++j) {
      double* const column = a + j * kRows + kFirst;
      Four sum[kLanes];
#pragma GCC unroll 16
      for (int v = 0; v < kLanes; ++v) sum[v] = four(column + 4 * v);
      for (int k = 0; k < j; ++k) {
        const double* const left = a + k * kRows + kFirst;
        const double share = left[j - kFirst];
#pragma GCC unroll 16
        for (int v = 0; v < kLanes; ++v) sum[v] -= share * four(left + 4 * v);
      }
      const double pivot = sum[0][j - kFirst];
      if (!(pivot > 0)) return false;
      const double inverse = 1 / std::sqrt(pivot);
#pragma GCC unroll 16
      for (int v = 0; v < kLanes; ++v) four(column + 4 * v) = sum[v] * inverse;
    }
    return true;
  }
};

}  // namespace traj
