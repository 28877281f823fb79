#pragma once

// Sums and products of doubles that lie on a known side of the real result.
//
// Example:
//   assert(geom::add_down(0.1, 0.2) < geom::add_up(0.1, 0.2));  // the sum is no double
//   assert(geom::add_up(1, 2) == 3);                            // exact
//   assert(geom::float_up(0.1) >= 0.1);
//
// Every result is the nearest double or its neighbour; exact where the real result is a double.
// Arguments and results must be finite.

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace geom {

inline double next_up(double x) {
  return std::nextafter(x, std::numeric_limits<double>::infinity());
}
inline double next_down(double x) {
  return std::nextafter(x, -std::numeric_limits<double>::infinity());
}

// From |x| to the next larger double.
inline double ulp(double x) {
  const double size = std::abs(x);
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(size) + 1) - size;
}

// The rounding error of `sum`, which is a + b as doubles add: TwoSum (Knuth 1969). Exact.
inline double sum_error(double a, double b, double sum) {
  const double b_part = sum - a;
  return (a - (sum - b_part)) + (b - b_part);
}

// The next larger double of a number that is not 0, if `steps`. Without branches, because whether a
// sum is exact cannot be predicted.
inline double next_up_if(bool steps, double x) {
  const auto bits = std::bit_cast<std::int64_t>(x);
  const std::int64_t sign = bits >> 63;  // all bits of a negative number
  return std::bit_cast<double>(bits + ((std::int64_t{steps} ^ sign) - sign));
}

// Not below and not above a + b. A sum that is 0, or so small that its neighbour is subnormal, is
// exact.
inline double add_up(double a, double b) {
  const double sum = a + b;
  return next_up_if(sum_error(a, b, sum) > 0, sum);
}
inline double add_down(double a, double b) {
  const double sum = a + b;
  return -next_up_if(sum_error(a, b, sum) < 0, -sum);
}

// Not below and not above a * b, where that is no subnormal number.
inline double multiply_up(double a, double b) {
  const double product = a * b;
  return std::fma(a, b, -product) > 0 ? next_up(product) : product;
}
inline double multiply_down(double a, double b) {
  const double product = a * b;
  return std::fma(a, b, -product) < 0 ? next_down(product) : product;
}

// The nearest float that is not below `x`.
inline float float_up(double x) {
  const float f = static_cast<float>(x);
  return f < x ? std::nextafter(f, std::numeric_limits<float>::infinity()) : f;
}
inline float float_down(double x) { return -float_up(-x); }

}  // namespace geom
