#pragma once

// Taylor models of order 1: what a quantity is for all values of some symbols in [-1, 1].

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

namespace traj {

// The quantity equals c + l . s + e for some e with |e| <= r, where s are `Symbols` symbols. Every
// operation keeps that true for the exact result: second-order terms and rounding go to the
// remainder r. Source: Makino and Berz, Taylor models and other validated functional inclusion
// methods, 2003.
template <int Symbols>
struct TaylorModelOf {
  static constexpr int kSymbols = Symbols;
  using Slope = Eigen::Array<double, kSymbols, 1>;

  double c = 0;
  Slope l = Slope::Zero();
  double r = 0;

  TaylorModelOf() = default;
  TaylorModelOf(double value) : c(value) {}  // NOLINT: numbers are models

  // Symbol k, scaled: c + radius * s_k.
  static TaylorModelOf symbol(double c, int k, double radius) {
    TaylorModelOf out(c);
    out.l[k] = radius;
    return out;
  }
  // Symbol k for 1 over anything in [least, most], which are positive.
  static TaylorModelOf inverse_of(double least, double most, int k) {
    const double low = 1 / most;
    const double high = 1 / least;
    return symbol(0.5 * (low + high), k, 0.5 * (high - low) * (1 + 1e-14));
  }
  // Anything within `radius` of c.
  static TaylorModelOf within(double c, double radius) {
    TaylorModelOf out(c);
    out.r = radius;
    return out;
  }

  // The same with the remainder as symbol k, which has not been in use.
  TaylorModelOf named(int k) const {
    TaylorModelOf out = *this;
    out.l[k] = r;
    out.r = 0;
    return out;
  }

  double swing() const { return l.abs().sum(); }         // of the linear part
  double radius() const { return kUp * (swing() + r); }  // of all that is not c
  double least() const { return c - radius() - kRounding * std::abs(c); }
  double most() const { return c + radius() + kRounding * std::abs(c); }

  static constexpr double kRounding = 1e-14;       // far above what an operation's sums lose
  static constexpr double kUp = 1 + 64 * 2.3e-16;  // above the rounding of a sum of all slopes

  // Adds what rounding may have lost in the parts of the result.
  friend TaylorModelOf rounded(TaylorModelOf m) {
    m.r = kUp * (m.r + kRounding * (std::abs(m.c) + m.swing()));
    return m;
  }

  friend TaylorModelOf operator-(const TaylorModelOf& a) {
    TaylorModelOf out;
    out.c = -a.c;
    out.l = -a.l;
    out.r = a.r;
    return out;
  }

  friend TaylorModelOf operator+(const TaylorModelOf& a, const TaylorModelOf& b) {
    TaylorModelOf out;
    out.c = a.c + b.c;
    out.l = a.l + b.l;
    out.r = a.r + b.r;
    return rounded(out);
  }

  friend TaylorModelOf operator-(const TaylorModelOf& a, const TaylorModelOf& b) {
    TaylorModelOf out;
    out.c = a.c - b.c;
    out.l = a.l - b.l;
    out.r = a.r + b.r;
    return rounded(out);
  }

  friend TaylorModelOf operator*(double k, const TaylorModelOf& a) {
    TaylorModelOf out;
    out.c = k * a.c;
    out.l = k * a.l;
    out.r = std::abs(k) * a.r;
    return rounded(out);
  }
  friend TaylorModelOf operator*(const TaylorModelOf& a, double k) { return k * a; }

  friend TaylorModelOf operator*(const TaylorModelOf& a, const TaylorModelOf& b) {
    TaylorModelOf out;
    out.c = a.c * b.c;
    out.l = a.c * b.l + b.c * a.l;
    const double x = a.swing();
    const double y = b.swing();
    out.r = std::abs(a.c) * b.r + std::abs(b.c) * a.r + (x + a.r) * (y + b.r);
    return rounded(out);
  }

  // g(a), where g and its slope at c are given, and a bound of |g''| over all values of a.
  friend TaylorModelOf composed(const TaylorModelOf& a, double value, double slope, double bend) {
    TaylorModelOf out;
    out.c = value;
    out.l = slope * a.l;
    const double radius = a.radius();
    out.r = std::abs(slope) * a.r + 0.5 * bend * radius * radius +
            4 * kRounding * (std::abs(value) + std::abs(slope * a.c));
    return rounded(out);
  }

  // The values of a must be positive; else the remainder is infinite.
  friend TaylorModelOf inverse(const TaylorModelOf& a) {
    const double least = a.least();
    if (!(least > 0)) return within(0, std::numeric_limits<double>::infinity());
    return composed(a, 1 / a.c, -1 / (a.c * a.c), 2 / (least * least * least));
  }

  friend TaylorModelOf sqrt(const TaylorModelOf& a) {
    const double least = a.least();
    if (!(least > 0)) return within(0, std::numeric_limits<double>::infinity());
    const double root = std::sqrt(a.c);
    return composed(a, root, 0.5 / root, 0.25 / (least * std::sqrt(least)));
  }

  friend TaylorModelOf sin(const TaylorModelOf& a) {
    return composed(a, std::sin(a.c), std::cos(a.c), 1);
  }
  friend TaylorModelOf cos(const TaylorModelOf& a) {
    return composed(a, std::cos(a.c), -std::sin(a.c), 1);
  }

  // The values of a must lie within (-1, 1); else the remainder is infinite.
  friend TaylorModelOf asin(const TaylorModelOf& a) {
    const double most = std::max(a.most(), -a.least());
    if (!(most < 1)) return within(0, std::numeric_limits<double>::infinity());
    const double room = 1 - most * most;
    return composed(a, std::asin(a.c), 1 / std::sqrt(1 - a.c * a.c),
                    most / (room * std::sqrt(room)));
  }

  friend TaylorModelOf operator/(const TaylorModelOf& a, const TaylorModelOf& b) {
    return a * inverse(b);
  }
};
using TaylorModel = TaylorModelOf<50>;
using CascadeModel = TaylorModelOf<64>;  // whose state has more coordinates

// The same for numbers, so that one text serves both.
inline double inverse(double a) { return 1 / a; }
inline double least(double a) { return a; }
inline double most(double a) { return a; }
template <int N>
double least(const TaylorModelOf<N>& a) {
  return a.least();
}
template <int N>
double most(const TaylorModelOf<N>& a) {
  return a.most();
}

}  // namespace traj
