#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "nlp_piece.h"

namespace traj {
namespace {

// The second derivatives of a block by two numbers of its states. There is a 4 x 4 matrix for each
// pair of axes, and for each pair of states: start and start, end and start, end and end. A matrix
// is added column by column, so four numbers are added at once.
class ByStates {
 public:
  ByStates() {
    for (Eigen::Matrix4d& sum : sum_) sum.setZero();
  }

  // The entry of numbers m and n along one axis. If m is of the start, n is, too.
  double& at(int m, int n, int axis) { return sum(m / 4 + n / 4, axis, axis)(m % 4, n % 4); }

  // Adds weight[m] weight[n] bend.
  void add(const std::array<double, kStates>& weight, const Eigen::Matrix3d& bend) {
    const Eigen::Vector4d start(weight.data());
    const Eigen::Vector4d end(weight.data() + 4);
    const bool by_start = !start.isZero(0);
    const bool by_end = !end.isZero(0);
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        if (by_start) add_to(sum(0, i, j), start * bend(i, j), start);
        if (by_start && by_end) add_to(sum(1, i, j), end * bend(i, j), start);
        if (by_end) add_to(sum(2, i, j), end * bend(i, j), end);
      }
    }
  }

  // The entries of start and end are those of end and start.
  void write(Nlp::Block& h) {
    constexpr int kJoint = Nlp::kJoint;
    for (int j = 0; j < 3; ++j) {
      for (int n = 0; n < 4; ++n) {
        double* const by_start = &h(0, local_of(n, j));
        double* const by_end = &h(0, local_of(4 + n, j));
        for (int i = 0; i < 3; ++i) {
          write(sum(0, i, j).col(n), by_start + i);
          write(sum(1, i, j).col(n), by_start + local_of(4, i));
          write(sum(2, i, j).col(n), by_end + local_of(4, i));
        }
      }
    }
    h.topRightCorner<kJoint, kJoint>() = h.bottomLeftCorner<kJoint, kJoint>().transpose();
  }

 private:
  using Quarter = Eigen::Matrix4d;

  static void add_to(Quarter& sum, const Eigen::Vector4d& row, const Eigen::Vector4d& column) {
#pragma GCC unroll 4
    for (int n = 0; n < 4; ++n) sum.col(n) += column[n] * row;
  }

  // The numbers of a state along one axis are three apart.
  static void write(const Eigen::Vector4d& column, double* to) {
#pragma GCC unroll 4
    for (int m = 0; m < 4; ++m) to[3 * m] = column[m];
  }

  Quarter& sum(int pair, int row_axis, int column_axis) {
    return sum_[static_cast<std::size_t>(9 * pair + 3 * row_axis + column_axis)];
  }

  std::array<Quarter, 27> sum_;
};

// Adds the second derivatives of factor * (rho * snap). Those by a state and the duration go into
// the column of the duration alone.
void add_snap(const std::array<Vec3, kStates>& absolute, const Powers& power, double factor,
              ByStates& by_states, Nlp::Block& h) {
  std::array<Vec3, kStates> state = absolute;
  state[4] -= state[0];
  state[0].setZero();
  for (int m = 0; m < kStates; ++m) {
    Vec3 in_time = Vec3::Zero();
    for (int n = 0; n < kStates; ++n) {
      const int e = power_of(m) + power_of(n) - kDegree;
      const double c = factor * kSnapForm[m][n];
      const bool made = m >= 4 || n < 4;
      for (int i = 0; made && i < 3; ++i) by_states.at(m, n, i) += 2 * c * power(e);
      in_time += (2 * c * e * power(e - 1)) * state[n];
      h(kTime, kTime) += c * e * (e - 1) / power(2) * power(e) * state[m].dot(state[n]);
    }
    for (int i = 0; i < 3; ++i) h(local_of(m, i), kTime) += in_time[i];
  }
}

// Adds the second derivatives of a function of one Bernstein point, whose own first derivative is
// `pull` and second `bend`: what the state and the duration do to the point, and how the point's
// own derivatives change with the duration. Entries by a state and the duration go into the column
// of the duration alone.
void add_point(const Nlp::Point& z, const Vec3& pull, const Eigen::Matrix3d& bend,
               ByStates& by_states, Nlp::Block& h) {
  by_states.add(z.weight, bend);
  const Vec3 in_time = bend * z.dt;
  for (int m = 0; m < kStates; ++m) {
    const double w = z.weight[static_cast<std::size_t>(m)];
    if (w == 0) continue;
    h.block<3, 1>(local_of(m, 0), kTime) +=
        w * in_time + z.weight_dt[static_cast<std::size_t>(m)] * pull;
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
  return condensed_block(index, x, points(x), factor, multipliers, {});
}

Nlp::Block Nlp::condensed_block(std::size_t index, std::span<const double> x,
                                std::span<const Point> points, double factor,
                                std::span<const double> multipliers,
                                std::span<const double> weights) const {
  const Piece p = piece(index, x);
  Block h = Block::Zero();
  ByStates by_states;
  add_snap(p.state, p.power, factor * spec_.rho, by_states, h);
  for (std::size_t g = first_group_[index]; g < first_group_[index + 1]; ++g) {
    const Group& group = groups_[g];
    const Point& z = points[g];
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
    add_point(z, pull, bend, by_states, h);
  }
  by_states.write(h);
  h.row(kTime) = h.col(kTime).transpose().eval();
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
