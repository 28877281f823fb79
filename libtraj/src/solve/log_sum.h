#pragma once

// Sums of logarithms, from + - * / alone: the same bits on every x86-64, and one series for all.

#include <bit>
#include <cmath>
#include <cstdint>
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
    product_ *= mantissa(x);
    if (product_ < kLeast) product_ = mantissa(product_);
  }

  // The natural logarithm of the product of all x: each adds an error of at most 2^-53, the
  // series a few ulp of the result.
  double value() const {
    constexpr double kLog2 = 0.6931471805599453;
    int exponent = 0;
    const double product = std::frexp(product_, &exponent);
    // log p = 2 atanh((p - 1) / (p + 1)), of p between 1 and 2 or their inverses.
    const bool small = product < 0.7071067811865476;
    const double p = small ? 2 * product : product;
    const double u = (p - 1) / (p + 1);
    double sum = 0;
    for (int n = 25; n >= 1; n -= 2) sum = sum * (u * u) + 1.0 / n;
    return 2 * u * sum + kLog2 * (exponent_ + exponent - (small ? 1 : 0));
  }

 private:
  // As std::frexp: x over a power of two, from 1/2 to 1. Adds the exponent.
  double mantissa(double x) {
    constexpr std::uint64_t kFraction = 0x000f'ffff'ffff'ffff;
    constexpr std::uint64_t kHalf = 0x3fe0'0000'0000'0000;
    const auto bits = std::bit_cast<std::uint64_t>(x);
    int exponent = static_cast<int>(bits >> 52);
    if (exponent == 0) {  // x is subnormal
      x = std::frexp(x, &exponent);
      exponent_ += exponent;
      return x;
    }
    exponent_ += exponent - 1022;
    return std::bit_cast<double>((bits & kFraction) | kHalf);
  }

  static constexpr double kLeast = 1e-200;

  double product_ = 1;  // at most 1, and more than kLeast / 2
  double exponent_ = 0;
};

}  // namespace traj
