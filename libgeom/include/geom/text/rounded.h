#pragma once

// Numbers with few digits for sentences that say "at least" or "at most", which must stay true.
//
// Example:
//   assert(std::abs(geom::rounded_down(4.37699) - 4.376) < 1e-12);   // "at least 4.376 m"
//   assert(std::abs(geom::rounded_up(0.42237) - 0.4224) < 1e-12);    // "at most 0.4224 m"

#include <cmath>

namespace geom {

// The largest multiple of `step` that is no more than `value`. A value that is a multiple but for
// its last bits (0.031 of 0.0001) stays itself.
inline double rounded_down_to(double value, double step) {
  const double steps = value / step;
  const double near = std::round(steps);
  return (std::abs(steps - near) <= 1e-9 ? near : std::floor(steps)) * step;
}

// The largest number of so many significant digits that is no more than `value`.
inline double rounded_down(double value, int digits = 4) {
  if (value == 0 || !std::isfinite(value)) return value;
  const double order = std::floor(std::log10(std::abs(value)));
  return rounded_down_to(value, std::pow(10, order - digits + 1));
}

// The least ones that are no less.
inline double rounded_up_to(double value, double step) { return -rounded_down_to(-value, step); }
inline double rounded_up(double value, int digits = 4) { return -rounded_down(-value, digits); }

}  // namespace geom
