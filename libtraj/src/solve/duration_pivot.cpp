#include "duration_pivot.h"

#include <algorithm>
#include <array>

#include "columns_cholesky.h"

namespace traj {
namespace {

constexpr int kJoint = Nlp::kJoint;
constexpr int kTime = Nlp::kTime;
constexpr int kBoth = 2 * kJoint;  // numbers of the states at both ends
constexpr int kRows = kBoth + 4;   // and below them the row of the duration
constexpr double kShift = 1e-6;
constexpr double kRounding = 1e-13;  // of the largest entry

using Columns = std::array<double, kBoth * kRows>;

}  // namespace

double duration_pivot(const Nlp::Block& block) {
  std::array<double, kBoth> diagonal;
  double most = 0;
  for (int j = 0; j < kBoth; ++j) {
    const int from = j < kJoint ? j : j + 1;
    double& own = diagonal[static_cast<std::size_t>(j)];
    own = block(from, from);
    own += own == 0 ? 1 : kShift;
    most = std::max(most, std::abs(own));
  }
  Columns factor{};
  const auto factored = [&]() SKYWAY_FOUR_LANES {
    for (int j = 0; j < kBoth; ++j) {
      const int from = j < kJoint ? j : j + 1;
      double* const column = &factor[static_cast<std::size_t>(j * kRows)];
      const double* const given = &block(0, from);
      if (j < kJoint) std::copy_n(given, kJoint, column);
      std::copy_n(given + kTime + 1, kJoint, column + kJoint);
      column[j] = diagonal[static_cast<std::size_t>(j)];
      column[kBoth] = j < kJoint ? given[kTime] : block(from, kTime);
    }
    return ColumnsCholesky<kBoth, kRows>::eliminate(factor.data());
  };
  for (double shift = kRounding; !with_four_lanes(factored) && shift < 10; shift *= 10) {
    for (double& own : diagonal) own += shift * most;
  }
  double eliminated = 0;
  for (int j = 0; j < kBoth; ++j) {
    const double half = factor[static_cast<std::size_t>(j * kRows + kBoth)];
    eliminated += half * half;
  }
  return block(kTime, kTime) - eliminated;
}

}  // namespace traj
