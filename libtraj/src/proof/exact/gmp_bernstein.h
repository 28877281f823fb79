#pragma once

// Bernstein forms in whole numbers. Every double is a whole number of 2^-1074, and halving a curve
// of degree n multiplies that unit by 2^-n instead of dividing.

#include <gmpxx.h>

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "traj/curve/trajectory.h"

namespace traj::exact {

using Whole = mpz_class;
using Point = std::array<Whole, 3>;
using Polynomial = std::vector<Whole>;  // coefficients up to a positive factor

inline constexpr unsigned kUnit = 1074;  // whole(x) = x 2^1074

inline Whole whole(double x) {
  int exponent = 0;
  const double mantissa = std::frexp(x, &exponent);
  const Whole m(std::ldexp(mantissa, 53));
  const int up = exponent - 53 + static_cast<int>(kUnit);
  if (up >= 0) return m << up;
  return m >> -up;  // a subnormal: these bits are 0
}

inline Point whole(const Vec3& p) { return {whole(p.x()), whole(p.y()), whole(p.z())}; }

// The control points times 2^(1074 + shift).
struct Curve {
  std::vector<Point> points;
  unsigned shift = 0;

  unsigned degree() const { return static_cast<unsigned>(points.size()) - 1; }
};

// De Casteljau with sums in place of means: both halves times 2^degree.
inline std::pair<Polynomial, Polynomial> halves(Polynomial q) {
  const std::size_t n = q.size() - 1;
  Polynomial left(n + 1);
  Polynomial right(n + 1);
  for (std::size_t m = 0; m <= n; ++m) {
    left[m] = q[0] << (n - m);
    right[n - m] = q[n - m] << (n - m);
    for (std::size_t i = 0; i + m < n; ++i) q[i] += q[i + 1];
  }
  return {std::move(left), std::move(right)};
}

inline std::pair<Curve, Curve> halves(const Curve& curve) {
  const unsigned shift = curve.shift + curve.degree();
  Curve left{std::vector<Point>(curve.points.size()), shift};
  Curve right = left;
  for (int axis = 0; axis < 3; ++axis) {
    Polynomial q;
    for (const Point& p : curve.points) q.push_back(p[axis]);
    auto [l, r] = halves(std::move(q));
    for (std::size_t i = 0; i < l.size(); ++i) {
      left.points[i][axis] = std::move(l[i]);
      right.points[i][axis] = std::move(r[i]);
    }
  }
  return {std::move(left), std::move(right)};
}

}  // namespace traj::exact
