#pragma once

// One period as a linear map of deviations and what it adds to them.

#include "tube/error_set.h"
#include "tube/loop_step.h"

namespace traj {

// Rows of the state.
inline constexpr int kVelocity = 3;
inline constexpr int kSpin = 13;
inline constexpr int kTurned = 19;
inline constexpr int kGust = 22;
inline constexpr int kWind = 25;  // from here on they do not change
inline constexpr int kLightness = 28;
inline constexpr int kDrag = 29;
inline constexpr int kQuickness = 30;
inline constexpr int kAgility = 31;

// Deviations e at the start of a period become map e + what is added, around `middle`. The gust's
// ball is not added yet.
struct PeriodMap {
  ErrorMatrix map = ErrorMatrix::Zero();
  PeriodErrors added;
  ErrorVector middle = ErrorVector::Zero();  // without the rows that do not change

  bool finite() const {
    return map.allFinite() && added.named.allFinite() && added.box.allFinite() &&
           middle.allFinite();
  }
};

// Bounds, over all deviations of a set, of what the symbols of a period stand for. They are the
// coordinates of the state, but for the gust. In its place stands the acceleration that lift and
// drag give together: they nearly balance, so its bound is far below theirs.
ErrorVector symbol_sizes(const Quadrotor& model, const ErrorSet& errors);

// The symbols of a period.
class PeriodSymbols {
 public:
  // `sizes`: what the symbols' coordinates are at most.
  PeriodSymbols(const Quadrotor& model, const ErrorVector& sizes);

  LoopState<TaylorModel> state(const ErrorVector& middle) const;

  // By the coordinates of the state.
  ErrorVector slopes(const TaylorModel& m) const;

  PeriodMap map(const LoopState<TaylorModel>& after) const;

 private:
  double drag_;  // 1/s
  ErrorMatrix mix_ = ErrorMatrix::Identity();
  ErrorVector scale_;
};

}  // namespace traj
