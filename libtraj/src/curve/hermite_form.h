#pragma once

// The degree-7 polynomial as its end states: constant tables, exact because they are integers over
// one denominator. Columns are (p, v, a, j) at the start, then at the end, each to be multiplied by
// duration^q, q = 0..3.

#include <array>

namespace traj {

inline constexpr int kStates = 8;  // p v a j at both ends

template <int Rows>
using StateTable = std::array<std::array<double, kStates>, Rows>;

// 210 times the Bernstein points of position.
inline constexpr StateTable<8> kPositionTable{{{210, 0, 0, 0, 0, 0, 0, 0},
                                               {210, 30, 0, 0, 0, 0, 0, 0},
                                               {210, 60, 5, 0, 0, 0, 0, 0},
                                               {210, 90, 15, 1, 0, 0, 0, 0},
                                               {0, 0, 0, 0, 210, -90, 15, -1},
                                               {0, 0, 0, 0, 210, -60, 5, 0},
                                               {0, 0, 0, 0, 210, -30, 0, 0},
                                               {0, 0, 0, 0, 210, 0, 0, 0}}};
inline constexpr double kPositionUnit = 210;

// The same for the derivative of order R, times duration^R.
template <int R>
constexpr StateTable<8 - R> derivative_table() {
  if constexpr (R == 0) {
    return kPositionTable;
  } else {
    const auto below = derivative_table<R - 1>();
    StateTable<8 - R> table{};
    for (int k = 0; k < 8 - R; ++k) {
      for (int m = 0; m < kStates; ++m) table[k][m] = (8 - R) * (below[k + 1][m] - below[k][m]);
    }
    return table;
  }
}

// 420 times the integral over [0, 1] of B(3, i) B(3, j).
inline constexpr double kSnapGramUnit = 420;
inline constexpr std::array<std::array<double, 4>, 4> kSnapGram{
    {{60, 30, 12, 3}, {30, 36, 27, 12}, {12, 27, 36, 30}, {3, 12, 30, 60}}};

// The integral of snap^2 as a quadratic form: the entry (m, n) is to be multiplied by
// duration^(q_m + q_n - 7).
constexpr StateTable<8> snap_form() {
  const auto snap = derivative_table<4>();
  StateTable<8> form{};
  for (int m = 0; m < kStates; ++m) {
    for (int n = 0; n < kStates; ++n) {
      double sum = 0;
      for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) sum += kSnapGram[i][j] * snap[i][m] * snap[j][n];
      }
      form[m][n] = sum / kSnapGramUnit / (kPositionUnit * kPositionUnit);
    }
  }
  return form;
}
inline constexpr StateTable<8> kSnapForm = snap_form();

}  // namespace traj
