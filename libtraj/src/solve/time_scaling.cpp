#include "solve/time_scaling.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "curve/bernstein.h"
#include "curve/halves.h"
#include "curve/portable_math.h"
#include "proof/check_limits.h"

namespace traj {
namespace {

constexpr double kGap = 2e-7;    // relative, between the bound found and the real peak
constexpr double kSlack = 1e-9;  // so that rounding in a sound checker does not matter
constexpr int kDeepest = 30;

// The peak of a convex function over a curve: control points bound it from above, the ends of
// (halved) pieces from below.
struct Peak {
  double below = 0;
  double above = 0;
};

template <std::size_t N, class Value>
void raise(Peak& peak, const std::array<Vec3, N>& q, const Value& value, int depth) {
  double above = 0;
  for (const Vec3& p : q) above = std::max(above, value(p));
  peak.below = std::max({peak.below, value(q.front()), value(q.back())});
  if (above <= peak.below * (1 + kGap) || depth == kDeepest) {
    peak.above = std::max(peak.above, above);
    return;
  }
  const auto [left, right] = halves(q);
  raise(peak, left, value, depth + 1);
  raise(peak, right, value, depth + 1);
}

template <class Points, class Value>
double upper_peak(const Trajectory& trajectory, const Points& points, const Value& value) {
  Peak peak;
  for (const Segment& s : trajectory.segments) raise(peak, points(s), value, 0);
  return peak.above;
}

// A factor of at least `factor` at which the thrust turns no faster. The rate falls with the cube
// of the factor once gravity outweighs the accelerations, not always before.
double held_turn_rate(const Trajectory& trajectory, double factor, double most) {
  for (int i = 0; i < 60; ++i) {
    CheckOptions options;
    options.limits[Limit::body_rate] = most * (1 - kSlack);
    CheckResult result;
    check_limits(slowed(trajectory, factor), options, result);
    if (result.reason == Reason::none) break;
    const double over = result.largest[Limit::body_rate]->value / most;
    factor *= std::isfinite(over) ? std::clamp(cube_root(over), 1 + 1e-6, 2.0) : 2;
  }
  return factor;
}

double norm(const Vec3& p) { return std::sqrt(p.squaredNorm()); }

}  // namespace

Trajectory slowed(const Trajectory& trajectory, double factor) {
  Trajectory out = trajectory;
  for (Segment& s : out.segments) s.duration *= factor;
  return out;
}

double smallest_factor(const Trajectory& trajectory, const Limits& limits) {
  double factor = 0;
  if (limits[Limit::speed]) {
    factor =
        std::max(factor, upper_peak(trajectory, velocity_points, norm) / *limits[Limit::speed]);
  }
  if (limits[Limit::horizontal_speed]) {
    const auto across = [](const Vec3& v) { return std::sqrt(v.x() * v.x() + v.y() * v.y()); };
    factor = std::max(
        factor, upper_peak(trajectory, velocity_points, across) / *limits[Limit::horizontal_speed]);
  }
  if (limits[Limit::vertical_speed]) {
    const auto up = [](const Vec3& v) { return std::abs(v.z()); };
    factor = std::max(factor,
                      upper_peak(trajectory, velocity_points, up) / *limits[Limit::vertical_speed]);
  }
  if (limits[Limit::thrust]) {
    // |a / f^2 + g| <= thrust: the least f^2 is the gauge of a ball around -g, so convex.
    const double room = *limits[Limit::thrust] * *limits[Limit::thrust] - kGravity * kGravity;
    const auto gauge = [&](const Vec3& a) {
      const double up = kGravity * a.z();
      return (up + std::sqrt(up * up + a.squaredNorm() * room)) / room;
    };
    factor = std::max(factor, std::sqrt(upper_peak(trajectory, acceleration_points, gauge)));
  }
  if (limits[Limit::acceleration]) {
    const double peak = upper_peak(trajectory, acceleration_points, norm);
    factor = std::max(factor, std::sqrt(peak / *limits[Limit::acceleration]));
  }
  if (limits[Limit::jerk]) {
    factor = std::max(factor,
                      cube_root(upper_peak(trajectory, jerk_points, norm) / *limits[Limit::jerk]));
  }
  if (limits[Limit::tilt]) {
    const double tangent = tangent_below(*limits[Limit::tilt]);
    // |a_xy| / f^2 <= tan (a_z / f^2 + g), solved for f^2.
    const auto lean = [&](const Vec3& a) {
      return std::sqrt(a.x() * a.x() + a.y() * a.y()) - tangent * a.z();
    };
    const double peak = upper_peak(trajectory, acceleration_points, lean);
    factor = std::max(factor, std::sqrt(peak / (tangent * kGravity)));
  }
  factor = factor > 0 ? factor * (1 + kSlack) : 1;
  if (limits[Limit::body_rate])
    factor = held_turn_rate(trajectory, factor, *limits[Limit::body_rate]);
  return factor;
}

}  // namespace traj
