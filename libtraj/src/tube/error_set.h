#pragma once

// The set of deviations from a nominal flight that the disturbances so far may have caused.

#include <Eigen/Core>
#include <deque>

#include "geom/base/vec3.h"
#include "tube/loop_step.h"

namespace traj {

template <class Rows>
using ErrorMatrixOf = Eigen::Matrix<double, Rows::kPadded, Rows::kPadded>;
template <class Rows>
using ErrorVectorOf = Eigen::Matrix<double, Rows::kPadded, 1>;
template <class Rows>
using ErrorColumnsOf = Eigen::Matrix<double, Rows::kPadded, Eigen::Dynamic>;

// Sums of two kinds of terms: three columns times a vector of length at most 1 (a ball), and a
// column times a number in [-1, 1] (an interval).
template <class Rows>
struct ErrorTermsOf {
  ErrorColumnsOf<Rows> balls = ErrorColumnsOf<Rows>(Rows::kPadded, 0);
  ErrorColumnsOf<Rows> intervals = ErrorColumnsOf<Rows>(Rows::kPadded, 0);
};

// What a period adds: the gust's ball, a column for each named error, and a box.
template <class Rows>
struct PeriodErrorsOf {
  Eigen::Matrix<double, Rows::kPadded, 3> gust = Eigen::Matrix<double, Rows::kPadded, 3>::Zero();
  Eigen::Matrix<double, Rows::kPadded, Rows::kNamed> named =
      Eigen::Matrix<double, Rows::kPadded, Rows::kNamed>::Zero();
  ErrorVectorOf<Rows> box = ErrorVectorOf<Rows>::Zero();  // of what changes
};

// Every deviation is a value of the sum of all terms. Terms grow fewer as they grow old: those of
// one kind and of neighbouring periods are added up, and a box holds what that loses. Rounding is
// covered.
template <class Rows>
class ErrorSetOf {
 public:
  using Matrix = ErrorMatrixOf<Rows>;
  using Vector = ErrorVectorOf<Rows>;
  using Terms = ErrorTermsOf<Rows>;

  // `held` never changes: what the mean wind and the mass do. `box` is what is not known at the
  // start.
  ErrorSetOf(Terms held, const Vector& box);

  // What boxes are taken along from now on, in place of the slow coordinates: linear forms that the
  // loop hardly mixes, a row each.
  using Forms = Eigen::Matrix<double, Eigen::Dynamic, Rows::kPadded>;
  void box_along(Forms forms) { forms_ = std::move(forms); }

  // Sensors are noisy from now on. What they do differs from period to period, so terms of a kind
  // are not added up with those of other periods.
  void take_noise() { noisy_ = true; }

  // Deviations e become map e + what the period adds.
  void advance(const Matrix& map, const PeriodErrorsOf<Rows>& added);

  // Upper bounds, over all deviations: of each coordinate's size, and of a linear form's.
  Vector bounds() const;
  double bound(const Vector& form) const;

  // Of the length of a linear image in space.
  double reach(const Eigen::Matrix<double, 3, Rows::kPadded>& map) const;

 private:
  void join_periods();
  void join_batches();
  void box_old();

  template <class F>
  void each(const F& f) const {
    f(held_);
    for (const auto* level : {&periods_, &joined_, &old_, &oldest_}) {
      for (const Terms& terms : *level) f(terms);
    }
  }

  ErrorColumnsOf<Rows> around(const ErrorColumnsOf<Rows>& columns) const;

  bool noisy_ = false;
  Forms forms_ = Forms(0, Rows::kPadded);
  Terms held_;
  std::deque<Terms> periods_;  // the newest, one each
  std::deque<Terms> joined_;   // kJoined periods each
  std::deque<Terms> old_;      // kBatches of those each
  std::deque<Terms> oldest_;   // boxes
};

inline constexpr int kErrorRows = GeometricRows::kPadded;
using ErrorMatrix = ErrorMatrixOf<GeometricRows>;
using ErrorVector = ErrorVectorOf<GeometricRows>;
using ErrorColumns = ErrorColumnsOf<GeometricRows>;
using ErrorTerms = ErrorTermsOf<GeometricRows>;
using PeriodErrors = PeriodErrorsOf<GeometricRows>;
using ErrorSet = ErrorSetOf<GeometricRows>;

}  // namespace traj
