#pragma once

// Bernstein points cut in two.

#include <array>
#include <cstddef>
#include <utility>

namespace traj {

// De Casteljau at one half, of numbers or vectors: the points of the first and of the second half,
// which share the middle one. Each of the N - 1 averagings rounds by at most 2^-53 of its value.
template <class T, std::size_t N>
std::pair<std::array<T, N>, std::array<T, N>> halves(std::array<T, N> q) {
  std::pair<std::array<T, N>, std::array<T, N>> out;
  for (std::size_t m = 0; m < N; ++m) {
    out.first[m] = q[0];
    out.second[N - 1 - m] = q[N - 1 - m];
    for (std::size_t i = 0; i + 1 + m < N; ++i) q[i] = 0.5 * (q[i] + q[i + 1]);
  }
  return out;
}

}  // namespace traj
