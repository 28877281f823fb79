#include "block_tridiagonal.h"

#include <Eigen/Cholesky>
#include <cassert>

namespace traj {
namespace {

using Vector = Eigen::Matrix<double, BlockTridiagonal::kSize, 1>;

Eigen::Map<Vector> part(std::span<double> b, std::size_t i) {
  return Eigen::Map<Vector>(&b[BlockTridiagonal::kSize * i]);
}

}  // namespace

bool BlockTridiagonal::factor() {
  for (std::size_t i = 0; i < diagonal_.size(); ++i) {
    Block& d = diagonal_[i];
    if (i > 0) {
      const Block& before = diagonal_[i - 1];
      Block& b = below_[i - 1];
      before.triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(b);
      d.noalias() -= b * b.transpose();
    }
    const Eigen::LLT<Block> cholesky(d);
    if (cholesky.info() != Eigen::Success) return false;
    d = cholesky.matrixLLT();
  }
  return true;
}

void BlockTridiagonal::solve(std::span<double> b) const {
  assert(b.size() == kSize * diagonal_.size());
  const std::size_t n = diagonal_.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (i > 0) part(b, i) -= below_[i - 1] * part(b, i - 1);
    Vector y = part(b, i);
    diagonal_[i].triangularView<Eigen::Lower>().solveInPlace(y);
    part(b, i) = y;
  }
  for (std::size_t i = n; i-- > 0;) {
    Vector y = part(b, i);
    if (i + 1 < n) y -= below_[i].transpose() * part(b, i + 1);
    diagonal_[i].triangularView<Eigen::Lower>().transpose().solveInPlace(y);
    part(b, i) = y;
  }
}

}  // namespace traj
