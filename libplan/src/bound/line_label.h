#pragma once

// Lower bounds of lengths along parts of edges, as lines, and how they go from part to part.
//
// A label of a part is a line over it, by its values at the low and the high end, that is nowhere
// above the length of any path that comes there. From a part i with a label to a point q, for every
// vector u of length 1 at most,
//   min over x in i of label(x) + |q - x|  >=  label(c) + u . (q - c) - h |l - u_i|,
// c the middle of i, h half its length, l the label's slope, u_i what u has of i's axis. With
// u from the best x to q it is an equality.
//
// Over a part j, f(q) = min over x of label(x) + |q - x| lies above its chord less what a distance
// |q - x| can sag below its own chord: by the best x of q, and f at the ends is no more than by
// that x. Along a line at r from x a distance d has the second derivative r^2 / d^3 <= 1 / d, so
// sag <= length^2 / 8 min(1 / d, r^2 / d^3), with the least d and the largest r of the two parts.
// Where that is more than d / 2, the constant min label + d is taken in its place.
// So what is carried on is never less than min label + d / 2, and grows with the label: there are
// no endless rounds.
//
// Rounding: no quantity here exceeds 8 `scale`, the sum of the coordinates' size and of the longest
// length asked about, and there are fewer than 64 roundings, each of 2^-53 of its result. `slack`,
// 2^-43 scale, is taken off what is carried on.

#include <algorithm>
#include <cmath>
#include <limits>

#include "convex_edges.h"

namespace plan {

struct LineLabel {
  double low = std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();

  double least() const { return std::min(low, high); }
  bool is_set() const { return low < std::numeric_limits<double>::infinity(); }
  // Nowhere below the other.
  bool covers(const LineLabel& other) const { return low >= other.low && high >= other.high; }

  friend LineLabel operator+(const LineLabel& a, const LineLabel& b) {
    return {a.low + b.low, a.high + b.high};
  }
  friend bool operator==(const LineLabel& a, const LineLabel& b) {
    return a.low == b.low && a.high == b.high;
  }
};

// Between any points of two parts, at least: rounded down.
inline double least_distance(const EdgePart& a, const EdgePart& b) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    const double gap = std::max({0.0, b.low[i] - a.high[i], a.low[i] - b.high[i]});
    sum += gap * gap;
  }
  return std::sqrt(sum) * (1 - 0x1p-50);
}

// The best of label(x) + |q - x|.
inline double carried_to(const EdgePart& part, const LineLabel& label, const Vec3& q) {
  if (part.is_corner()) return label.low + (q - part.low).norm();
  const int k = part.axis;
  const double half = 0.5 * (part.high[k] - part.low[k]);
  const double dy = q[(k + 1) % 3] - part.low[(k + 1) % 3];
  const double dz = q[(k + 2) % 3] - part.low[(k + 2) % 3];
  const double r2 = dy * dy + dz * dz;
  const double a = q[k] - 0.5 * (part.low[k] + part.high[k]);
  const double slope = half > 0 ? (label.high - label.low) / (2 * half) : 0;
  double x = slope > 0 ? -half : half;
  if (std::abs(slope) < 1) {
    x = std::clamp(a - slope * std::sqrt(r2 / ((1 - slope) * (1 + slope))), -half, half);
  }
  const double along = a - x;
  const double d = std::sqrt(r2 + along * along);
  if (!(d > 0)) return label.least();
  const double u = along / d;
  return 0.5 * (label.low + label.high) + u * a + r2 / d - half * std::abs(slope - u);
}

// The label of part `to` by way of part `from`; `d` is least_distance() of the two.
inline LineLabel carried(const EdgePart& from, const LineLabel& label, const EdgePart& to, double d,
                         double slack) {
  if (to.is_corner()) {
    const double value = carried_to(from, label, to.low) - slack;
    return {value, value};
  }
  const int k = to.axis;
  const double length = to.high[k] - to.low[k];
  double r2 = 0;
  for (const int i : {(k + 1) % 3, (k + 2) % 3}) {
    const double r =
        std::max(std::abs(from.low[i] - to.low[i]), std::abs(from.high[i] - to.low[i]));
    r2 += r * r;
  }
  const double sag = length * length / 8 * std::min(1.0, r2 / (d * d)) / d;
  if (!(sag <= 0.5 * d) || d < 8 * slack) {
    const double value = label.least() + std::max(0.0, d - slack);
    return {value, value};
  }
  return {carried_to(from, label, to.low) - sag - slack,
          carried_to(from, label, to.high) - sag - slack};
}

}  // namespace plan
