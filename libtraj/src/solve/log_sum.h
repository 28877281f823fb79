#pragma once

// Sums of logarithms, from + - * / alone: the same bits on every x86-64, and one series for all.

#include <cmath>
#include <limits>

namespace traj {

class LogSum {
 public:
  // x > 0; otherwise, and where x is not finite, the sum is no number.
  void add(double x) {
    if (!(x > 0 && x <= std::numeric_limits<double>::max())) {
      product_ = std::numeric_limits<double>::quiet_NaN();
      return;
    }
    int exponent = 0;
    product_ = std::frexp(std::frexp(x, &exponent) * product_, &last_);
    exponent_ += exponent + last_;
  }

  // The natural logarithm of the product of all x: each adds an error of at most 2^-53, the
  // series a few ulp of the result.
  double value() const {
    constexpr double kLog2 = 0.6931471805599453;
    // log p = 2 atanh((p - 1) / (p + 1)), of p between 1 and 2 or their inverses.
    const bool small = product_ < 0.7071067811865476;
    const double p = small ? 2 * product_ : product_;
    const double u = (p - 1) / (p + 1);
    double sum = 0;
    for (int n = 25; n >= 1; n -= 2) sum = sum * (u * u) + 1.0 / n;
    return 2 * u * sum + kLog2 * (exponent_ - (small ? 1 : 0));
  }

 private:
  double product_ = 1;  // at least 1/2, at most 1
  double exponent_ = 0;
  int last_ = 0;
};

}  // namespace traj
