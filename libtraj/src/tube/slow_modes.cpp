#include "tube/slow_modes.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <complex>

namespace traj {
namespace {

using Rows = CascadeRows;
using Matrix = ErrorMatrixOf<Rows>;
using Forms = ErrorSetOf<Rows>::Forms;

constexpr double kSlowest = 12;  // rad/s

// What concerns a movement along x, along y, up, and about the vertical, where the heading is 0.
const std::vector<std::vector<int>> kAxes = {{0, 3, 6, 11, 14, 17, 20, 22, 25, 28},
                                             {1, 4, 7, 10, 13, 16, 19, 23, 26, 29},
                                             {2, 5, 8, 24, 27, 30},
                                             {9, 12, 15, 18, 21}};

// Turns what is seen from the body, by the heading, into the axes of the map.
Matrix level(double yaw) {
  Matrix out = Matrix::Identity();
  for (const int row : {6, 10, 13, 16, 19}) {
    out(row, row) = out(row + 1, row + 1) = std::cos(yaw);
    out(row, row + 1) = -std::sin(yaw);
    out(row + 1, row) = std::sin(yaw);
  }
  return out;
}

void add_modes(const Matrix& map, const std::vector<int>& axis, double milliseconds,
               std::vector<Eigen::RowVectorXd>& forms) {
  const Eigen::MatrixXd block = map(axis, axis).transpose();
  const Eigen::EigenSolver<Eigen::MatrixXd> modes(block);
  if (modes.info() != Eigen::Success) return;
  for (Eigen::Index k = 0; k < block.rows(); ++k) {
    const std::complex<double> mode = modes.eigenvalues()[k];
    const double rate = -1e3 * std::log(std::abs(mode)) / milliseconds;
    if (!(rate < kSlowest) || mode.imag() < 0) continue;
    const Eigen::VectorXcd form = modes.eigenvectors().col(k);
    const auto add = [&](const Eigen::VectorXd& part) {
      forms.emplace_back(Eigen::RowVectorXd::Zero(Rows::kPadded));
      for (std::size_t i = 0; i < axis.size(); ++i) forms.back()[axis[i]] = part[i];
    };
    add(form.real());
    if (mode.imag() > 0) add(form.imag());
  }
}

}  // namespace

Forms slow_modes(const Matrix& map, double yaw, double milliseconds) {
  const Matrix turn = level(yaw);
  const Matrix levelled = turn * map * turn.transpose();
  std::vector<Eigen::RowVectorXd> forms;
  for (const std::vector<int>& axis : kAxes) add_modes(levelled, axis, milliseconds, forms);
  Forms out(static_cast<Eigen::Index>(forms.size()), Rows::kPadded);
  for (std::size_t k = 0; k < forms.size(); ++k) {
    out.row(static_cast<Eigen::Index>(k)) = forms[k] * turn;
  }
  return out;
}

}  // namespace traj
