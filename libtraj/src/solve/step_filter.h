#pragma once

// Which steps of an interior point method are progress: less violation, or less of the objective
// with its barriers, compared with every point that was left behind.

#include <vector>

namespace traj {

// What is compared: the sum of the constraints' violations, and the objective with its barriers.
struct Progress {
  double violation = 0;
  double barrier = 0;
};

// Wächter and Biegler, On the implementation of an interior-point filter line-search algorithm
// (2006), section 2.3, without its restoration phase.
class StepFilter {
 public:
  // `start`: the violation of the first point. Far above it no step is accepted.
  explicit StepFilter(double start);

  // Whether to go from `from` to `to`, a share `length` of a step along which the barrier falls by
  // -slope to first order (slope < 0: it falls). Remembers `from` where the violation is what
  // counted.
  bool accepts(const Progress& from, const Progress& to, double slope, double length);

  void forget() { left_.clear(); }  // where the barrier has another weight from now on

 private:
  double most_;
  double little_;
  std::vector<Progress> left_;
};

}  // namespace traj
