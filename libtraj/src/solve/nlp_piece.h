#pragma once

// One piece of the optimiser's problem: its Bernstein points as functions of the states at its ends
// and its duration. Local indices: the state at the start, the duration, the state at the end.

#include <array>

#include "curve/hermite_form.h"
#include "nlp.h"

namespace traj {

inline constexpr int kTime = Nlp::kTime;  // local index of the duration
constexpr std::array<StateTable<8>, 4> padded_tables() {
  std::array<StateTable<8>, 4> out{};
  const auto copy = [&](int order, const auto& table) {
    for (std::size_t k = 0; k < table.size(); ++k) {
      for (int m = 0; m < kStates; ++m) out[order][k][m] = table[k][m] / kPositionUnit;
    }
  };
  copy(0, derivative_table<0>());
  copy(1, derivative_table<1>());
  copy(2, derivative_table<2>());
  copy(3, derivative_table<3>());
  return out;
}
inline constexpr std::array<StateTable<8>, 4> kTables = padded_tables();  // [order][point][state]

constexpr int power_of(int state) { return state % 4; }
constexpr int local_of(int state, int axis) { return 3 * state + axis + (state >= 4 ? 1 : 0); }

// duration^e for e = kLeast..kMost.
struct Powers {
  static constexpr int kLeast = -8;
  static constexpr int kMost = 3;

  explicit Powers(double t) {
    at(0) = 1;
    for (int e = 1; e <= kMost; ++e) at(e) = at(e - 1) * t;
    for (int e = -1; e >= kLeast; --e) at(e) = at(e + 1) / t;
  }
  double operator()(int e) const { return value[static_cast<std::size_t>(e - kLeast)]; }
  double& at(int e) { return value[static_cast<std::size_t>(e - kLeast)]; }
  std::array<double, kMost - kLeast + 1> value;
};

struct Nlp::Piece {
  std::array<Vec3, kStates> state;
  double time;
  Powers power;

  Vec3 value(int order, int index) const {
    Vec3 sum = Vec3::Zero();
    for (int m = 0; m < kStates; ++m) {
      const double c = kTables[order][index][m];
      if (c != 0) sum += (c * power(power_of(m) - order)) * state[m];
    }
    return sum;
  }

  Point point(int order, int index) const {
    Point p;
    for (int m = 0; m < kStates; ++m) {
      const double c = kTables[order][index][m];
      if (c == 0) continue;
      const int e = power_of(m) - order;
      const double dt = c * e * power(e - 1);
      p.weight[m] = c * power(e);
      p.weight_dt[m] = dt;
      p.value += p.weight[m] * state[m];
      p.dt += dt * state[m];
      p.dtt += (c * e * (e - 1) * power(e - 2)) * state[m];
    }
    return p;
  }
};

}  // namespace traj
