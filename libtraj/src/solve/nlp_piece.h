#pragma once

// One piece of the optimiser's problem: its Bernstein points as functions of the states at its ends
// and its duration. Local indices: the state at the start, the duration, the state at the end.

#include <array>
#include <span>

#include "curve/hermite_form.h"
#include "four_lanes.h"
#include "nlp.h"

namespace traj {

inline constexpr int kTime = Nlp::kTime;  // local index of the duration

constexpr int power_of(int state) { return state % 4; }
constexpr int local_of(int state, int axis) { return 3 * state + axis + (state >= 4 ? 1 : 0); }

// What the d-th derivative of duration^e makes of its factor.
constexpr double falling(int e, int d) { return d == 0 ? 1 : e * falling(e - 1, d - 1); }

inline constexpr int kTimeDerivatives = 3;         // none, one, two
using PointTables = std::array<StateTable<8>, 4>;  // [order][point][state]

// Of the Bernstein points, and their derivatives by the duration.
constexpr std::array<PointTables, kTimeDerivatives> point_tables() {
  std::array<PointTables, kTimeDerivatives> out{};
  const auto add = [&](int order, const auto& table) {
    for (std::size_t k = 0; k < table.size(); ++k) {
      for (int m = 0; m < kStates; ++m) {
        for (int d = 0; d < kTimeDerivatives; ++d) {
          out[d][order][k][m] = table[k][m] / kPositionUnit * falling(power_of(m) - order, d);
        }
      }
    }
  };
  add(0, derivative_table<0>());
  add(1, derivative_table<1>());
  add(2, derivative_table<2>());
  add(3, derivative_table<3>());
  return out;
}
inline constexpr auto kPointTables = point_tables();
inline constexpr const PointTables& kTables = kPointTables[0];

// Of the snap, and its derivatives by the duration.
constexpr std::array<StateTable<8>, kTimeDerivatives> snap_tables() {
  std::array<StateTable<8>, kTimeDerivatives> out{};
  for (int d = 0; d < kTimeDerivatives; ++d) {
    for (int n = 0; n < kStates; ++n) {
      for (int m = 0; m < kStates; ++m) {
        out[d][n][m] = kSnapForm[n][m] * falling(power_of(m) + power_of(n) - kDegree, d);
      }
    }
  }
  return out;
}
inline constexpr auto kSnapTables = snap_tables();

// duration^e for e = kLeast..kMost.
struct Powers {
  static constexpr int kLeast = -kDegree - 2;
  static constexpr int kMost = 3;

  explicit Powers(double t) {
    at(0) = 1;
    for (int e = 1; e <= kMost; ++e) at(e) = at(e - 1) * t;
    const double inverse = 1 / t;
    for (int e = -1; e >= kLeast; --e) at(e) = at(e + 1) * inverse;
  }
  double& at(int e) { return value[static_cast<std::size_t>(e - kLeast)]; }
  // Those of e to e + 3, which belong to the four numbers of a state.
  SKYWAY_FOUR_LANES const double* from(int e) const {
    return &value[static_cast<std::size_t>(e - kLeast)];
  }
  std::array<double, kMost - kLeast + 1> value;
};

struct Nlp::Piece {
  std::array<Lanes, kStates> state;
  double time;
  Powers power;

  // What each state counts in a derivative by the duration of a Bernstein point.
  template <int kTimes>
  SKYWAY_FOUR_LANES void weigh(int order, int index, double* weight) const {
    const double* const table = kPointTables[kTimes][order][index].data();
    const double* const powers = power.from(-order - kTimes);
    four(weight) = four(table) * four(powers);
    four(weight + 4) = four(table + 4) * four(powers);
  }

  SKYWAY_FOUR_LANES void sum(const double* weight, Lanes& out) const {
    Four all = {};
#pragma GCC unroll 8
    for (std::size_t m = 0; m < kStates; ++m) all += weight[m] * four(state[m].data());
    four(out.data()) = all;
  }

  SKYWAY_FOUR_LANES void value(int order, int index, Lanes& out) const {
    double weight[kStates];
    weigh<0>(order, index, weight);
    sum(weight, out);
  }

  SKYWAY_FOUR_LANES void point(int order, int index, Point& out) const {
    double weight[kStates];
    weigh<2>(order, index, weight);
    sum(weight, out.dtt);
    weigh<1>(order, index, out.weight_dt.data());
    sum(out.weight_dt.data(), out.dt);
    weigh<0>(order, index, out.weight.data());
    sum(out.weight.data(), out.value);
  }

  // The snap does not see a common shift; without it large coordinates cancel badly.
  SKYWAY_FOUR_LANES void shift_to_start() {
    four(state[4].data()) -= four(state[0].data());
    four(state[0].data()) = Four{};
  }

  // The snap's quadratic form times the states, derived by the duration. Half of the snap's own
  // derivatives by the states, of a piece that is shifted to its start.
  template <int kTimes>
  SKYWAY_FOUR_LANES void snap_times_states(std::array<Lanes, kStates>& out) const {
    Four sum[kStates] = {};
    for (int n = 0; n < kStates; ++n) {
      double weight[kStates];
      snap_row<kTimes>(n, weight);
      const Four by = four(state[static_cast<std::size_t>(n)].data());
#pragma GCC unroll 8
      for (int m = 0; m < kStates; ++m) sum[m] += weight[m] * by;
    }
#pragma GCC unroll 8
    for (std::size_t m = 0; m < kStates; ++m) four(out[m].data()) = sum[m];
  }

  // A row, or column, of that form.
  template <int kTimes>
  SKYWAY_FOUR_LANES void snap_row(int n, double* weight) const {
    const double* const table = kSnapTables[kTimes][static_cast<std::size_t>(n)].data();
    const double* const powers = power.from(power_of(n) - kDegree - kTimes);
    four(weight) = four(table) * four(powers);
    four(weight + 4) = four(table + 4) * four(powers);
  }

  // The sum of the states' products with others.
  SKYWAY_FOUR_LANES double times_states(const std::array<Lanes, kStates>& others) const {
    Four sum = {};
#pragma GCC unroll 8
    for (std::size_t m = 0; m < kStates; ++m) sum += four(state[m].data()) * four(others[m].data());
    return sum[0] + sum[1] + sum[2];
  }
};

SKYWAY_FOUR_LANES inline void Nlp::joint(std::size_t joint, std::span<const double> x,
                                         Lanes* out) const {
  for (std::size_t q = 0; q < 4; ++q) out[q] = guess_[4 * joint + q];
  if (joint == 0 || joint == spec_.corridor.size()) return;
  const double* const y = &x[kPiece * joint - kJoint];
  const std::array<double, 4>& scale = spec_.scale[joint];
  for (std::size_t i = 0; i < 3; ++i) {
    out[0][i] += y[i];
    for (std::size_t q = 1; q < 4; ++q) out[q][i] = y[3 * q + i] * scale[q];
  }
}

SKYWAY_FOUR_LANES inline Nlp::Piece Nlp::piece(std::size_t index, std::span<const double> x) const {
  const double t = x[kPiece * index];
  Piece out{{}, t, Powers(t)};
  joint(index, x, &out.state[0]);
  joint(index + 1, x, &out.state[4]);
  return out;
}

}  // namespace traj
