#pragma once

// The set of deviations from a nominal flight that the disturbances so far may have caused.

#include <Eigen/Core>
#include <deque>

#include "geom/base/vec3.h"
#include "tube/loop_step.h"

namespace traj {

inline constexpr int kErrorRows = kLoopStates;
using ErrorMatrix = Eigen::Matrix<double, kErrorRows, kErrorRows>;
using ErrorVector = Eigen::Matrix<double, kErrorRows, 1>;
using ErrorColumns = Eigen::Matrix<double, kErrorRows, Eigen::Dynamic>;

// Sums of two kinds of terms: three columns times a vector of length at most 1 (a ball), and a
// column times a number in [-1, 1] (an interval).
struct ErrorTerms {
  ErrorColumns balls = ErrorColumns(kErrorRows, 0);
  ErrorColumns intervals = ErrorColumns(kErrorRows, 0);
};

// What a period adds: the gust's ball, a column for each named error, and a box.
struct PeriodErrors {
  Eigen::Matrix<double, kErrorRows, 3> gust = Eigen::Matrix<double, kErrorRows, 3>::Zero();
  Eigen::Matrix<double, kErrorRows, kNamedErrors> named =
      Eigen::Matrix<double, kErrorRows, kNamedErrors>::Zero();
  ErrorVector box = ErrorVector::Zero();  // of the first kMovingStates
};

// Every deviation is a value of the sum of all terms. Terms grow fewer as they grow old: those of
// one kind and of neighbouring periods are added up, and a box holds what that loses. Rounding is
// covered.
class ErrorSet {
 public:
  // `held` never changes: what the mean wind and the mass do. `box` is what is not known at the
  // start.
  ErrorSet(ErrorTerms held, const ErrorVector& box);

  // Deviations e become map e + what the period adds.
  void advance(const ErrorMatrix& map, const PeriodErrors& added);

  // Upper bounds, over all deviations: of each coordinate's size, and of a linear form's.
  ErrorVector bounds() const;
  double bound(const ErrorVector& form) const;

  // Of the length of a linear image in space.
  double reach(const Eigen::Matrix<double, 3, kErrorRows>& map) const;

 private:
  void join_periods();
  void join_batches();
  void box_old();

  template <class F>
  void each(const F& f) const {
    f(held_);
    for (const auto* level : {&periods_, &joined_, &old_, &oldest_}) {
      for (const ErrorTerms& terms : *level) f(terms);
    }
  }

  ErrorTerms held_;
  std::deque<ErrorTerms> periods_;  // the newest, one each
  std::deque<ErrorTerms> joined_;   // kJoined periods each
  std::deque<ErrorTerms> old_;      // kBatches of those each
  std::deque<ErrorTerms> oldest_;   // boxes
};

}  // namespace traj
