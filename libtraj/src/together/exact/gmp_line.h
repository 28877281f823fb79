#pragma once

// A flight over time in whole numbers (GMP), for the exact checks.

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "proof/exact/gmp_bernstein.h"
#include "traj/together/timed_flight.h"

namespace traj::exact {

// Times of a flight in units of 2^-1074 s, and its segments.
struct Line {
  explicit Line(const TimedFlight& flight) : segments(flight.trajectory->segments) {
    joint.push_back(whole(flight.start));
    for (const Segment& s : segments) joint.push_back(joint.back() + whole(s.duration));
    for (std::size_t i = 0; i + 1 < segments.size(); ++i) {
      const Point end = whole(segments[i].point.back());
      const Point begin = whole(segments[i + 1].point.front());
      for (std::size_t axis = 0; axis < 3; ++axis) {
        gap = std::max<Whole>(gap, abs(begin[axis] - end[axis]));
      }
    }
  }

  const std::vector<Segment>& segments;
  std::vector<Whole> joint;
  Whole gap = 0;  // of a coordinate, in units of 2^-1074 m
};

// Control points times 2^1074 and times `factor`, which is > 0.
struct Scaled {
  std::array<Polynomial, 3> axes;
  Whole factor = 1;
};

inline Scaled constant(const Vec3& p) {
  Scaled out;
  const Point at = whole(p);
  for (std::size_t axis = 0; axis < 3; ++axis) out.axes[axis].assign(kPoints, at[axis]);
  return out;
}

// De Casteljau at share / of: the first part or the second, times of^7.
inline Polynomial part(Polynomial q, const Whole& share, const Whole& of, bool second) {
  const std::size_t n = q.size() - 1;
  const Whole rest = of - share;
  std::vector<Whole> power(n + 1, Whole(1));
  for (std::size_t m = 1; m <= n; ++m) power[m] = power[m - 1] * of;
  Polynomial out(n + 1);
  for (std::size_t m = 0; m <= n; ++m) {
    out[second ? n - m : m] = (second ? q[n - m] : q[0]) * power[n - m];
    for (std::size_t i = 0; i + m < n; ++i) q[i] = rest * q[i] + share * q[i + 1];
  }
  return out;
}

inline void cut(Scaled& curve, Whole share, Whole of, bool second) {
  const Whole common = gcd(share, of);
  share /= common;
  of /= common;
  for (Polynomial& q : curve.axes) q = part(std::move(q), share, of, second);
  for (std::size_t i = 1; i < kPoints; ++i) curve.factor *= of;
}

// The flight from `begin` to `end`, between which it has no joint; where it is parked, at rest.
inline Scaled between(const Line& line, const Whole& begin, const Whole& end) {
  if (end <= line.joint.front()) return constant(line.segments.front().point.front());
  if (begin >= line.joint.back()) return constant(line.segments.back().point.back());
  const auto next = std::upper_bound(line.joint.begin(), line.joint.end(), begin);
  const auto i = static_cast<std::size_t>(next - line.joint.begin()) - 1;
  Scaled out;
  for (const Vec3& p : line.segments[i].point) {
    const Point at = whole(p);
    for (std::size_t axis = 0; axis < 3; ++axis) out.axes[axis].push_back(at[axis]);
  }
  const Whole& from = line.joint[i];
  const Whole& until = line.joint[i + 1];
  if (end < until) cut(out, end - from, until - from, false);
  if (begin > from) cut(out, begin - from, end - from, true);
  return out;
}

}  // namespace traj::exact
