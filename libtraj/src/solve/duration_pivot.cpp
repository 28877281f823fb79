#include "duration_pivot.h"

#include <Eigen/Cholesky>

namespace traj {
namespace {

constexpr int kJoint = Nlp::kJoint;
constexpr int kTime = Nlp::kTime;
constexpr int kBoth = 2 * kJoint;  // numbers of the states at both ends
constexpr double kShift = 1e-6;
constexpr double kRounding = 1e-13;  // of the largest entry

using States = Eigen::Matrix<double, kBoth, kBoth>;
using Column = Eigen::Matrix<double, kBoth, 1>;

}  // namespace

double duration_pivot(const Nlp::Block& block) {
  States states;
  states << block.topLeftCorner<kJoint, kJoint>(), block.topRightCorner<kJoint, kJoint>(),
      block.bottomLeftCorner<kJoint, kJoint>(), block.bottomRightCorner<kJoint, kJoint>();
  Column mixed;
  mixed << block.block<kJoint, 1>(0, kTime), block.block<kJoint, 1>(kTime + 1, kTime);
  for (int i = 0; i < kBoth; ++i) states(i, i) += states(i, i) == 0 ? 1 : kShift;
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
