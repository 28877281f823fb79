#include "duration_pivot.h"

#include <Eigen/Cholesky>

namespace traj {
namespace {

constexpr int kTime = 12;  // local index of the duration
constexpr double kShift = 1e-6;
constexpr double kRounding = 1e-13;  // of the largest entry

using States = Eigen::Matrix<double, 24, 24>;
using Column = Eigen::Matrix<double, 24, 1>;

}  // namespace

double duration_pivot(const Nlp::Block& block) {
  States states;
  states << block.topLeftCorner<12, 12>(), block.topRightCorner<12, 12>(),
      block.bottomLeftCorner<12, 12>(), block.bottomRightCorner<12, 12>();
  Column mixed;
  mixed << block.block<12, 1>(0, kTime), block.block<12, 1>(kTime + 1, kTime);
  for (int i = 0; i < 24; ++i) states(i, i) += states(i, i) == 0 ? 1 : kShift;
  const double most = states.diagonal().cwiseAbs().maxCoeff();
  Eigen::LLT<States> factor(states);
  for (double shift = kRounding; factor.info() != Eigen::Success && shift < 10; shift *= 10) {
    states.diagonal().array() += shift * most;
    factor.compute(states);
  }
  const Column half = factor.matrixL().solve(mixed);
  return block(kTime, kTime) - half.squaredNorm();
}

}  // namespace traj
