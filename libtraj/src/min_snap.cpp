#include "traj/min_snap.h"

#include <Eigen/Cholesky>
#include <array>
#include <cassert>
#include <vector>

#include "hermite_form.h"

namespace traj {
namespace {

using Mat3 = Eigen::Matrix3d;

enum End { kStart = 0, kEnd = 4 };  // columns of the Hermite tables

struct Legs {
  std::vector<Vec3> point;
  std::vector<double> time;
};

Legs without_repeats(std::span<const Vec3> waypoints, std::span<const double> times) {
  Legs legs;
  legs.point.push_back(waypoints[0]);
  for (std::size_t i = 1; i < waypoints.size(); ++i) {
    if (waypoints[i] == legs.point.back()) continue;
    legs.point.push_back(waypoints[i]);
    legs.time.push_back(times[i - 1]);
  }
  return legs;
}

Trajectory rest_at(const Vec3& p, std::span<const double> times) {
  double sum = 0;
  for (const double t : times) sum += t;
  return {{hermite({p}, {p}, sum > 0 ? sum : 1)}};
}

// duration^-e for e = 0..6.
std::array<double, 7> inverse_powers(double duration) {
  std::array<double, 7> power;
  power[0] = 1;
  for (std::size_t e = 1; e < power.size(); ++e) power[e] = power[e - 1] / duration;
  return power;
}

// The block of the snap form between (v, a, j) at two ends of a leg.
Mat3 block(const std::array<double, 7>& inverse, End row, End column) {
  Mat3 m;
  for (int q = 1; q <= 3; ++q) {
    for (int r = 1; r <= 3; ++r) {
      m(q - 1, r - 1) = kSnapForm[row + q][column + r] * inverse[7 - q - r];
    }
  }
  return m;
}

// What a step from one end of a leg to the other pulls on (v, a, j): one column an axis. The form
// does not see a common shift, so the step is all that counts, and large coordinates cost nothing.
Mat3 pull(const std::array<double, 7>& inverse, End row, const Vec3& step) {
  Mat3 m;
  for (int q = 1; q <= 3; ++q) {
    m.row(q - 1) = -kSnapForm[row + q][kEnd] * inverse[7 - q] * step.transpose();
  }
  return m;
}

// The symmetric block-tridiagonal system at the inner waypoints. Cholesky needs no pivots and is
// indifferent to the scale of single unknowns, so very unequal legs do no harm.
struct Inner {
  Eigen::LLT<Mat3> factor;
  Mat3 to_next;  // factor^-1 times the coupling to the next waypoint
  Mat3 value;    // rows v, a, j; columns x, y, z
};

std::vector<Inner> solve_inner(const Legs& legs, double unit) {
  const std::size_t n = legs.time.size();
  std::vector<Inner> inner(n - 1);
  Mat3 carried = Mat3::Zero();
  Mat3 carried_pull = Mat3::Zero();
  std::array<double, 7> before = inverse_powers(legs.time[0] / unit);
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const std::array<double, 7> after = inverse_powers(legs.time[i + 1] / unit);
    const Mat3 diagonal = block(before, kEnd, kEnd) + block(after, kStart, kStart) - carried;
    const Mat3 right = pull(before, kEnd, legs.point[i + 1] - legs.point[i]) +
                       pull(after, kStart, legs.point[i + 2] - legs.point[i + 1]) - carried_pull;
    const Mat3 coupling = block(after, kStart, kEnd);
    inner[i].factor.compute(diagonal);
    inner[i].to_next = inner[i].factor.solve(coupling);
    inner[i].value = inner[i].factor.solve(right);
    carried = coupling.transpose() * inner[i].to_next;
    carried_pull = coupling.transpose() * inner[i].value;
    before = after;
  }
  for (std::size_t i = inner.size() - 1; i-- > 0;) {
    inner[i].value -= inner[i].to_next * inner[i + 1].value;
  }
  return inner;
}

State state_of(const Vec3& p, const Mat3& value, double unit) {
  return {p, value.row(0).transpose() / unit, value.row(1).transpose() / (unit * unit),
          value.row(2).transpose() / (unit * unit * unit)};
}

}  // namespace

Trajectory min_snap(std::span<const Vec3> waypoints, std::span<const double> times) {
  assert(!waypoints.empty() && times.size() + 1 == waypoints.size());
  const Legs legs = without_repeats(waypoints, times);
  const std::size_t n = legs.time.size();
  if (n == 0) return rest_at(legs.point[0], times);
  double unit = 0;  // the mean leg: keeps the powers of time in range
  for (const double t : legs.time) unit += t / static_cast<double>(n);
  std::vector<State> state(n + 1);
  state.front().position = legs.point.front();
  state.back().position = legs.point.back();
  if (n > 1) {
    const std::vector<Inner> inner = solve_inner(legs, unit);
    for (std::size_t i = 1; i < n; ++i) {
      state[i] = state_of(legs.point[i], inner[i - 1].value, unit);
    }
  }
  Trajectory trajectory;
  trajectory.segments.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    trajectory.segments.push_back(hermite(state[i], state[i + 1], legs.time[i]));
  }
  return trajectory;
}

}  // namespace traj
