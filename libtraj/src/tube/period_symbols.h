#pragma once

// One period as a linear map of deviations and what it adds to them.

#include "tube/error_set.h"
#include "tube/loop_step.h"

namespace traj {

// Deviations e at the start of a period become map e + what is added, around `middle`. The gust's
// ball is not added yet.
template <class Rows>
struct PeriodMapOf {
  ErrorMatrixOf<Rows> map = ErrorMatrixOf<Rows>::Zero();
  PeriodErrorsOf<Rows> added;
  ErrorVectorOf<Rows> middle = ErrorVectorOf<Rows>::Zero();  // without the rows that do not change

  bool finite() const {
    return map.allFinite() && added.named.allFinite() && added.box.allFinite() &&
           middle.allFinite();
  }
};

// Bounds, over all deviations of a set, of what the symbols of a period stand for. They are the
// coordinates of the state, but for the gust. In its place stands the acceleration that lift and
// drag give together: they nearly balance, so its bound is far below theirs.
template <class Rows>
ErrorVectorOf<Rows> symbol_sizes(const Quadrotor& model, const ErrorSetOf<Rows>& errors);

// The symbols of a period.
template <class Rows>
class PeriodSymbolsOf {
 public:
  using Model = typename Rows::Model;
  using State = typename Rows::template State<Model>;
  using Vector = ErrorVectorOf<Rows>;

  // `sizes`: what the symbols' coordinates are at most.
  PeriodSymbolsOf(const Quadrotor& model, const Vector& sizes);

  State state(const Vector& middle) const;

  // By the coordinates of the state.
  Vector slopes(const Model& m) const;

  PeriodMapOf<Rows> map(const State& after) const;

 private:
  double drag_;  // 1/s
  ErrorMatrixOf<Rows> mix_ = ErrorMatrixOf<Rows>::Identity();
  Vector scale_;
};

inline constexpr int kVelocity = GeometricRows::kVelocity;
inline constexpr int kGust = GeometricRows::kGust;
inline constexpr int kWind = GeometricRows::kWind;
inline constexpr int kLightness = GeometricRows::kLightness;
using PeriodMap = PeriodMapOf<GeometricRows>;
using PeriodSymbols = PeriodSymbolsOf<GeometricRows>;

}  // namespace traj
