#include "tube/period_symbols.h"

#include "tube/cascade_state.h"

namespace traj {
namespace {

// The least radius of a symbol: slopes are needed of coordinates that do not vary yet, too.
constexpr double kLeastScale = 1e-9;
constexpr double kRounding = 1e-12;  // far above what dividing by the scales loses

double drag_of(const Quadrotor& model) { return model.drag.x() / model.mass; }  // 1/s

// What the symbols are of the coordinates.
template <class Rows>
ErrorMatrixOf<Rows> mix_of(double drag) {
  ErrorMatrixOf<Rows> mix = ErrorMatrixOf<Rows>::Identity();
  for (int i = 0; i < 3; ++i) {
    const int row = Rows::kGust + i;
    mix(row, i) = 1;
    mix(row, Rows::kVelocity + i) = -drag;
    mix(row, row) = drag;
    mix(row, Rows::kWind + i) = drag;
  }
  return mix;
}

}  // namespace

template <class Rows>
ErrorVectorOf<Rows> symbol_sizes(const Quadrotor& model, const ErrorSetOf<Rows>& errors) {
  ErrorVectorOf<Rows> out = errors.bounds();
  const double drag = drag_of(model);
  if (drag == 0) return out;
  const ErrorMatrixOf<Rows> mix = mix_of<Rows>(drag);
  for (int row = Rows::kGust; row < Rows::kGust + 3; ++row)
    out[row] = errors.bound(mix.row(row).transpose());
  return out;
}

template <class Rows>
PeriodSymbolsOf<Rows>::PeriodSymbolsOf(const Quadrotor& model, const Vector& sizes)
    : drag_(drag_of(model)), scale_(sizes.cwiseMax(kLeastScale)) {
  if (drag_ != 0) mix_ = mix_of<Rows>(drag_);
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

template ErrorVectorOf<GeometricRows> symbol_sizes(const Quadrotor&,
                                                   const ErrorSetOf<GeometricRows>&);
template ErrorVectorOf<CascadeRows> symbol_sizes(const Quadrotor&, const ErrorSetOf<CascadeRows>&);
template class PeriodSymbolsOf<GeometricRows>;
template class PeriodSymbolsOf<CascadeRows>;

}  // namespace traj
