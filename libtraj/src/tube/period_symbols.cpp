#include "tube/period_symbols.h"

#include "tube/cascade_state.h"

namespace traj {
namespace {

// The least radius of a symbol: slopes are needed of coordinates that do not vary yet, too.
constexpr double kLeastScale = 1e-9;
constexpr double kRounding = 1e-12;  // far above what dividing by the scales loses

}  // namespace

template <class Rows>
PeriodSymbolsOf<Rows>::PeriodSymbolsOf(const Quadrotor& model, const ErrorSetOf<Rows>& errors)
    : drag_(model.drag.x() / model.mass), scale_(errors.bounds().cwiseMax(kLeastScale)) {
  if (drag_ == 0) return;
  for (int i = 0; i < 3; ++i) {
    const int row = Rows::kGust + i;
    mix_(row, i) = 1;
    mix_(row, Rows::kVelocity + i) = -drag_;
    mix_(row, row) = drag_;
    mix_(row, Rows::kWind + i) = drag_;
    scale_[row] = std::max(errors.bound(mix_.row(row).transpose()), kLeastScale);
  }
}

template <class Rows>
typename PeriodSymbolsOf<Rows>::State PeriodSymbolsOf<Rows>::state(const Vector& middle) const {
  State state;
  for_each(state, [&](int i, Model& m) { m = Model::symbol(middle[i], i, scale_[i]); });
  if (drag_ == 0) return state;
  const auto gust = [&](int i, const Model& lift, const Model& velocity, const Model& wind) {
    const Model acceleration = Model::symbol(0, Rows::kGust + i, scale_[Rows::kGust + i]);
    return middle[Rows::kGust + i] + (1 / drag_) * (acceleration - (lift - middle[i])) +
           (velocity - middle[Rows::kVelocity + i]) - (wind - middle[Rows::kWind + i]);
  };
  state.gust = {gust(0, state.lift.x, state.velocity.x, state.wind.x),
                gust(1, state.lift.y, state.velocity.y, state.wind.y),
                gust(2, state.lift.z, state.velocity.z, state.wind.z)};
  return state;
}

template <class Rows>
ErrorVectorOf<Rows> PeriodSymbolsOf<Rows>::slopes(const Model& m) const {
  Vector by_symbol = Vector::Zero();
  by_symbol.template head<Rows::kStates>() =
      (m.l.template head<Rows::kStates>() / scale_.template head<Rows::kStates>().array()).matrix();
  return mix_.transpose() * by_symbol;
}

template <class Rows>
PeriodMapOf<Rows> PeriodSymbolsOf<Rows>::map(const State& after) const {
  PeriodMapOf<Rows> out;
  State state = after;
  for_each(state, [&](int i, const Model& m) {
    if (i >= Rows::kWind) {
      out.map(i, i) = 1;
      return;
    }
    out.middle[i] = m.c;
    out.map.row(i) = slopes(m).transpose();
    for (int k = 0; k < Rows::kNamed; ++k) out.added.named(i, k) = m.l[Rows::kStates + k];
    out.added.box[i] = m.r + kRounding * m.swing();
  });
  return out;
}

template class PeriodSymbolsOf<GeometricRows>;
template class PeriodSymbolsOf<CascadeRows>;

}  // namespace traj
