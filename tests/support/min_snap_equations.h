#pragma once

// The textbook equations of minimum snap, with nothing clever about them: 8 coefficients a leg,
// waypoints, rest at both ends, and derivatives 1 to 6 continuous.

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "traj/curve/trajectory.h"

namespace support {

// matrix * x = right; x holds, for each leg, the coefficients of (t / duration)^k, k = 0 to 7, a
// column an axis.
struct MinSnapEquations {
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixXd right;

  Eigen::MatrixXd dense() const {
    Eigen::MatrixXd m = Eigen::MatrixXd::Zero(right.rows(), right.rows());
    for (const auto& e : entries) m(e.row(), e.col()) += e.value();
    return m;
  }
  Eigen::SparseMatrix<double> sparse() const {
    Eigen::SparseMatrix<double> m(right.rows(), right.rows());
    m.setFromTriplets(entries.begin(), entries.end());
    return m;
  }
};

inline MinSnapEquations min_snap_equations(std::span<const traj::Vec3> points,
                                           std::span<const double> times) {
  const int n = static_cast<int>(times.size());
  MinSnapEquations equations;
  equations.right = Eigen::MatrixXd::Zero(8 * n, 3);
  int row = 0;
  // Derivative d at the start (end = 0) or end (1) of a leg.
  const auto put = [&](int leg, int d, int end, double sign) {
    double scale = sign;
    for (int i = 0; i < d; ++i) scale /= times[static_cast<std::size_t>(leg)];
    for (int k = d; k < (end ? 8 : d + 1); ++k) {
      double c = scale;
      for (int i = 0; i < d; ++i) c *= k - i;
      equations.entries.emplace_back(row, 8 * leg + k, c);
    }
  };
  for (int d = 1; d <= 3; ++d, ++row) put(0, d, 0, 1);
  for (int leg = 0; leg < n; ++leg) {
    for (int end = 0; end < 2; ++end, ++row) {
      put(leg, 0, end, 1);
      equations.right.row(row) = points[static_cast<std::size_t>(leg + end)].transpose();
    }
    for (int d = 1; d <= 6 && leg + 1 < n; ++d, ++row) {
      put(leg, d, 1, 1);
      put(leg + 1, d, 0, -1);
    }
  }
  for (int d = 1; d <= 3; ++d, ++row) put(n - 1, d, 1, 1);
  return equations;
}

// The trajectory of a solution.
inline traj::Trajectory trajectory_of(const Eigen::MatrixXd& x, std::span<const double> times) {
  constexpr std::array<double, 8> kChoose7{1, 7, 21, 35, 35, 21, 7, 1};
  traj::Trajectory trajectory;
  for (std::size_t leg = 0; leg < times.size(); ++leg) {
    traj::Segment segment;
    segment.duration = times[leg];
    for (std::size_t i = 0; i < 8; ++i) {
      double choose = 1;  // i over k
      segment.point[i] = traj::Vec3::Zero();
      for (std::size_t k = 0; k <= i; ++k) {
        segment.point[i] +=
            choose / kChoose7[k] * x.row(static_cast<Eigen::Index>(8 * leg + k)).transpose();
        choose = choose * static_cast<double>(i - k) / static_cast<double>(k + 1);
      }
    }
    trajectory.segments.push_back(segment);
  }
  return trajectory;
}

}  // namespace support
