#include "tube/period_symbols.h"

namespace traj {
namespace {

// The least radius of a symbol: slopes are needed of coordinates that do not vary yet, too.
constexpr double kLeastScale = 1e-9;
constexpr double kRounding = 1e-12;  // far above what dividing by the scales loses

double drag_of(const Quadrotor& model) { return model.drag.x() / model.mass; }  // 1/s

// What the symbols are of the coordinates.
ErrorMatrix mix_of(double drag) {
  ErrorMatrix mix = ErrorMatrix::Identity();
  for (int i = 0; i < 3; ++i) {
    const int row = kGust + i;
    mix(row, i) = 1;
    mix(row, kVelocity + i) = -drag;
    mix(row, row) = drag;
    mix(row, kWind + i) = drag;
  }
  return mix;
}

}  // namespace

ErrorVector symbol_sizes(const Quadrotor& model, const ErrorSet& errors) {
  ErrorVector out = errors.bounds();
  const double drag = drag_of(model);
  if (drag == 0) return out;
  const ErrorMatrix mix = mix_of(drag);
  for (int row = kGust; row < kWind; ++row) out[row] = errors.bound(mix.row(row).transpose());
  return out;
}

PeriodSymbols::PeriodSymbols(const Quadrotor& model, const ErrorVector& sizes)
    : drag_(drag_of(model)), scale_(sizes.cwiseMax(kLeastScale)) {
  if (drag_ != 0) mix_ = mix_of(drag_);
}

LoopState<TaylorModel> PeriodSymbols::state(const ErrorVector& middle) const {
  LoopState<TaylorModel> state;
  for_each(state, [&](int i, TaylorModel& m) { m = TaylorModel::symbol(middle[i], i, scale_[i]); });
  if (drag_ == 0) return state;
  const auto gust = [&](int i, const TaylorModel& lift, const TaylorModel& velocity,
                        const TaylorModel& wind) {
    const TaylorModel acceleration = TaylorModel::symbol(0, kGust + i, scale_[kGust + i]);
    return middle[kGust + i] + (1 / drag_) * (acceleration - (lift - middle[i])) +
           (velocity - middle[kVelocity + i]) - (wind - middle[kWind + i]);
  };
  state.gust = {gust(0, state.lift.x, state.velocity.x, state.wind.x),
                gust(1, state.lift.y, state.velocity.y, state.wind.y),
                gust(2, state.lift.z, state.velocity.z, state.wind.z)};
  return state;
}

ErrorVector PeriodSymbols::slopes(const TaylorModel& m) const {
  ErrorVector by_symbol = ErrorVector::Zero();
  by_symbol.head<kLoopStates>() =
      (m.l.head<kLoopStates>() / scale_.head<kLoopStates>().array()).matrix();
  return mix_.transpose() * by_symbol;
}

PeriodMap PeriodSymbols::map(const LoopState<TaylorModel>& after) const {
  PeriodMap out;
  LoopState<TaylorModel> state = after;
  for_each(state, [&](int i, const TaylorModel& m) {
    if (i >= kWind) {
      out.map(i, i) = 1;
      return;
    }
    out.middle[i] = m.c;
    out.map.row(i) = slopes(m).transpose();
    for (int k = 0; k < kNamedErrors; ++k) out.added.named(i, k) = m.l[kLoopStates + k];
    out.added.box[i] = m.r + kRounding * m.swing();
  });
  return out;
}

}  // namespace traj
