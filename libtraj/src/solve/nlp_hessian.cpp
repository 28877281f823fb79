#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>

#include "four_lanes.h"
#include "nlp_piece.h"

namespace traj {
namespace {

using Bend = std::array<Nlp::Lanes, 3>;  // the second derivatives by a point: a symmetric matrix

// The second derivatives of a block by two numbers of its states, below its diagonal. There is a
// 4 x 4 matrix for each pair of states (start and start, end and start, end and end) and each pair
// of axes; the pairs xy and yx share one. A column of four numbers is added at once.
class ByStates {
 public:
  static constexpr std::size_t kAxes = 6;  // xx, yx, zx, yy, zy, zz
  template <class Index>
  static constexpr std::size_t pair_of(Index i, Index j) {
    const auto least = static_cast<std::size_t>(std::min(i, j));
    return least * (5 - least) / 2 + static_cast<std::size_t>(std::max(i, j));
  }

  // Adds to column n, along each axis, its four entries by the numbers of the start or of the end.
  // A column of the end (n >= 4) has entries by the end alone.
  SKYWAY_FOUR_LANES void add_along_axes(int n, bool of_end, const double* column) {
    for (int axis = 0; axis < 3; ++axis) {
      four(sum_[(of_end ? 1 : 0) + n / 4][pair_of(axis, axis)][n % 4]) += four(column);
    }
  }

  // Adds weight[m] weight[n] bend.
  SKYWAY_FOUR_LANES void add(const std::array<double, kStates>& weight, const Bend& bend) {
    const double* const start = weight.data();
    const double* const end = start + 4;
    const bool by_start = std::any_of(start, end, [](double w) { return w != 0; });
    const bool by_end = std::any_of(end, end + 4, [](double w) { return w != 0; });
    if (by_start) add_to(sum_[0], start, start, bend);
    if (by_start && by_end) add_to(sum_[1], end, start, bend);
    if (by_end) add_to(sum_[2], end, end, bend);
  }

  // Writes the lower triangle, scaled; numbers of a state along one axis are three apart.
  SKYWAY_FOUR_LANES void write(const std::array<double, Nlp::kLocal>& scales, Nlp::Block& h) const {
    for (int n = 0; n < kStates; ++n) {
      for (int j = 0; j < 3; ++j) {
        double* const column = &h(0, local_of(n, j));
        const double by_column = scales[static_cast<std::size_t>(local_of(n, j))];
        for (int part = n / 4; part < 2; ++part) {
          for (int i = 0; i < 3; ++i) {
            const auto& from = sum_[part + n / 4][pair_of(i, j)][n % 4];
            const int to = local_of(4 * part, i);
#pragma GCC unroll 4
            for (int m = 0; m < 4; ++m) {
              column[to + 3 * m] =
                  from[m] * (by_column * scales[static_cast<std::size_t>(to + 3 * m)]);
            }
          }
        }
      }
    }
  }

 private:
  using Quarter = double[4][4];  // columns

  SKYWAY_FOUR_LANES static void add_to(Quarter* sums, const double* row, const double* column,
                                       const Bend& bend) {
    for (int n = 0; n < 4; ++n) {
      if (column[n] == 0) continue;  // most points do not depend on all numbers of a state
      const Four outer = four(row) * column[n];
#pragma GCC unroll 3
      for (std::size_t j = 0; j < 3; ++j) {
#pragma GCC unroll 3
        for (std::size_t i = j; i < 3; ++i) four(sums[pair_of(i, j)][n]) += bend[j][i] * outer;
      }
    }
  }

  Quarter sum_[3][kAxes] = {};
};

// The second derivatives by the duration and another number: each state's, and its own.
struct ByDuration {
  std::array<Nlp::Lanes, kStates> state{};
  double itself = 0;

  // Writes the duration's row and its column, scaled.
  SKYWAY_FOUR_LANES void write(const std::array<double, Nlp::kLocal>& scales, Nlp::Block& h) const {
    for (int m = 0; m < kStates; ++m) {
      for (int i = 0; i < 3; ++i) {
        const int local = local_of(m, i);
        const double entry = state[static_cast<std::size_t>(m)][static_cast<std::size_t>(i)];
        (m < 4 ? h(kTime, local) : h(local, kTime)) =
            entry * scales[static_cast<std::size_t>(local)];
      }
    }
    h(kTime, kTime) = itself;
  }
};

// Adds the second derivatives of factor * snap.
SKYWAY_FOUR_LANES inline void add_snap(Nlp::Piece p, double factor, ByStates& by_states,
                                       ByDuration& by_duration) {
  p.shift_to_start();
  for (int n = 0; n < kStates; ++n) {
    double column[kStates];
    p.snap_row<0>(n, column);
    four(column) *= 2 * factor;
    four(column + 4) *= 2 * factor;
    if (n < 4) by_states.add_along_axes(n, false, column);
    by_states.add_along_axes(n, true, column + 4);
  }
  std::array<Nlp::Lanes, kStates> half;
  p.snap_times_states<1>(half);
#pragma GCC unroll 8
  for (std::size_t m = 0; m < kStates; ++m) {
    four(by_duration.state[m].data()) += 2 * factor * four(half[m].data());
  }
  p.snap_times_states<2>(half);
  by_duration.itself += factor * p.times_states(half);
}

// Adds the second derivatives of a function of one Bernstein point, whose own first derivative is
// `pull` and second `bend`: what the state and the duration do to the point, and how the point's
// own derivatives change with the duration.
SKYWAY_FOUR_LANES inline void add_point(const Nlp::Point& z, const Four& pull, const Bend& bend,
                                        ByStates& by_states, ByDuration& by_duration) {
  by_states.add(z.weight, bend);
  const Four in_time = z.dt[0] * four(bend[0].data()) + z.dt[1] * four(bend[1].data()) +
                       z.dt[2] * four(bend[2].data());
#pragma GCC unroll 8
  for (std::size_t m = 0; m < kStates; ++m) {
    four(by_duration.state[m].data()) += z.weight[m] * in_time + z.weight_dt[m] * pull;
  }
  const Four both = in_time * four(z.dt.data()) + pull * four(z.dtt.data());
  by_duration.itself += both[0] + both[1] + both[2];
}

// Adds weight v v'.
SKYWAY_FOUR_LANES inline void add_square(const Nlp::Lanes& v, double weight, Bend& bend) {
#pragma GCC unroll 3
  for (std::size_t i = 0; i < 3; ++i) four(bend[i].data()) += weight * v[i] * four(v.data());
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

void Nlp::condense(std::size_t index, std::span<const double> x, std::span<const Point> points,
                   double factor, std::span<const double> multipliers,
                   std::span<const double> weights, Block& h) const {
  ByStates by_states;
  ByDuration by_duration;
  std::array<double, kLocal> scales;
  for (int i = 0; i < kLocal; ++i) {
    scales[static_cast<std::size_t>(i)] = global(index, i) < 0 ? 0 : scale(index, i);
  }
  const auto add_all = [&]() SKYWAY_FOUR_LANES {
    add_snap(piece(index, x), factor * spec_.rho, by_states, by_duration);
    for (std::size_t g = first_group_[index]; g < first_group_[index + 1]; ++g) {
      const Point& z = points[g];
      Four pull = {};
      Bend bend{};
      for (std::size_t r = groups_[g].first_row; r < groups_[g].last_row; ++r) {
        const Row& row = rows_[r];
        Lanes by_point;
        slope(row, z.value, by_point.data());
        pull += multipliers[r] * four(by_point.data());
        if (!weights.empty()) add_square(by_point, weights[r], bend);
        if (row.order == 0) continue;
#pragma GCC unroll 3
        for (std::size_t i = 0; i < 3; ++i) {
          bend[i][i] += 2 * multipliers[r] * limits_[row.limit].weight[i];
        }
      }
      add_point(z, pull, bend, by_states, by_duration);
    }
    by_states.write(scales, h);
    by_duration.write(scales, h);
  };
  with_four_lanes(add_all);
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
