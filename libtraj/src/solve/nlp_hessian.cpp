#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "nlp_piece.h"

namespace traj {
namespace {

// Adds factor * (rho * snap)'s second derivatives, lower triangle.
void add_snap(const std::array<Vec3, kStates>& absolute, const Powers& power, double factor,
              Nlp::Block& h) {
  std::array<Vec3, kStates> state = absolute;
  state[4] -= state[0];
  state[0].setZero();
  for (int m = 0; m < kStates; ++m) {
    Vec3 in_time = Vec3::Zero();
    for (int n = 0; n < kStates; ++n) {
      const int e = power_of(m) + power_of(n) - kDegree;
      const double c = factor * kSnapForm[m][n];
      for (int i = 0; i < 3; ++i) h(local_of(m, i), local_of(n, i)) += 2 * c * power(e);
      in_time += (2 * c * e * power(e - 1)) * state[n];
      h(kTime, kTime) += c * e * (e - 1) / power(2) * power(e) * state[m].dot(state[n]);
    }
    for (int i = 0; i < 3; ++i) {
      h(local_of(m, i), kTime) += in_time[i];
      h(kTime, local_of(m, i)) += in_time[i];
    }
  }
}

// Adds the second derivatives of a function of one Bernstein point, whose own first derivative is
// `pull` and second `bend`: what the state and the duration do to the point, and how the point's
// own derivatives change with the duration.
void add_point(const Point& z, const Vec3& pull, const Eigen::Matrix3d& bend, Nlp::Block& h) {
  const Vec3 in_time = bend * z.dt;
  for (int m = 0; m < kStates; ++m) {
    const double w = z.weight[static_cast<std::size_t>(m)];
    if (w == 0) continue;
    const Eigen::Matrix3d part = w * bend;
    for (int n = 0; n < kStates; ++n) {
      const double other = z.weight[static_cast<std::size_t>(n)];
      if (other != 0) h.block<3, 3>(local_of(m, 0), local_of(n, 0)) += other * part;
    }
    const Vec3 mixed = w * in_time + z.weight_dt[static_cast<std::size_t>(m)] * pull;
    h.block<3, 1>(local_of(m, 0), kTime) += mixed;
    h.block<1, 3>(kTime, local_of(m, 0)) += mixed.transpose();
  }
  h(kTime, kTime) += in_time.dot(z.dt) + pull.dot(z.dtt);
}

// The block with its eigenvalues' signs dropped. Most are positive definite already, and Cholesky
// tells at a fraction of the cost.
Nlp::Block made_positive(const Nlp::Block& h, const std::array<bool, Nlp::kLocal>& fixed) {
  Nlp::Block definite = h;
  for (int i = 0; i < Nlp::kLocal; ++i) {
    if (fixed[static_cast<std::size_t>(i)]) definite(i, i) = 1;
  }
  if (Eigen::LLT<Nlp::Block>(definite).info() == Eigen::Success) return h;
  const Eigen::SelfAdjointEigenSolver<Nlp::Block> eigen(h);
  const Nlp::Block& q = eigen.eigenvectors();
  return q * eigen.eigenvalues().cwiseAbs().asDiagonal() * q.transpose();
}

}  // namespace

Nlp::Block Nlp::hessian_block(std::size_t index, std::span<const double> x, double factor,
                              std::span<const double> multipliers) const {
  return condensed_block(index, x, factor, multipliers, {});
}

Nlp::Block Nlp::condensed_block(std::size_t index, std::span<const double> x, double factor,
                                std::span<const double> multipliers,
                                std::span<const double> weights) const {
  const Piece p = piece(index, x);
  Block h = Block::Zero();
  add_snap(p.state, p.power, factor * spec_.rho, h);
  for (const Group& group : groups(index)) {
    const Point z = p.point(group.order, group.point);
    Vec3 pull = Vec3::Zero();
    Eigen::Matrix3d bend = Eigen::Matrix3d::Zero();
    for (std::size_t r = group.first_row; r < group.last_row; ++r) {
      const Vec3 by_point = slope(rows_[r], z.value);
      pull += multipliers[r] * by_point;
      if (!weights.empty()) bend += (weights[r] * by_point) * by_point.transpose();
      if (group.order > 0) {
        bend.diagonal() += 2 * multipliers[r] * spec_.limits[rows_[r].limit].weight;
      }
    }
    add_point(z, pull, bend, h);
  }
  for (int i = 0; i < kLocal; ++i) {
    const double s = global(index, i) < 0 ? 0 : scale(index, i);
    h.row(i) *= s;
    h.col(i) *= s;
  }
  return h;
}

std::vector<double> Nlp::hessian(std::span<const double> x, double factor,
                                 std::span<const double> multipliers) const {
  std::vector<double> out;
  out.reserve(hessian_entries_.size());
  for (std::size_t k = 0; k < spec_.corridor.size(); ++k) {
    std::array<bool, kLocal> fixed;
    for (int i = 0; i < kLocal; ++i) fixed[static_cast<std::size_t>(i)] = global(k, i) < 0;
    const Block h = made_positive(hessian_block(k, x, factor, multipliers), fixed);
    for (int i = 0; i < kLocal; ++i) {
      for (int j = 0; j <= i; ++j) {
        if (!fixed[static_cast<std::size_t>(i)] && !fixed[static_cast<std::size_t>(j)]) {
          out.push_back(h(i, j));
        }
      }
    }
  }
  return out;
}

}  // namespace traj
