#include "solve/stop_and_go.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "curve/portable_math.h"
#include "solve/time_scaling.h"

namespace traj {
namespace {

// Peaks of the derivatives of 35 u^4 - 84 u^5 + 70 u^6 - 20 u^7 on [0, 1]: at 1/2, at
// 1/2 +- 1/sqrt(20), and at 1/2.
constexpr double kPeakSpeed = 35.0 / 16;
constexpr double kPeakJerk = 105.0 / 2;
const double kPeakAcceleration = 84 * std::sqrt(5.0) / 25;

// The largest acceleration to and fro along `step` that keeps the tilt: |a_xy| <= tan (a_z + g)
// for both signs.
double acceleration_within(double tilt, const Vec3& step) {
  const double tangent = tangent_below(tilt);
  const double across = std::sqrt(step.x() * step.x() + step.y() * step.y());
  return tangent * kGravity * step.norm() / (across + tangent * std::abs(step.z()));
}

// The same that keeps |a + g| <= thrust.
double acceleration_within_thrust(double thrust, const Vec3& step) {
  const double up = kGravity * std::abs(step.z()) / step.norm();
  return std::sqrt(up * up + thrust * thrust - kGravity * kGravity) - up;
}

double shortest(const Vec3& step, const Limits& limits) {
  const double length = step.norm();
  double t = 0;
  const auto accelerating = [&](double amax) {
    return std::sqrt(kPeakAcceleration * length / amax);
  };
  if (limits[Limit::speed]) t = std::max(t, kPeakSpeed * length / *limits[Limit::speed]);
  if (limits[Limit::horizontal_speed]) {
    const double across = std::sqrt(step.x() * step.x() + step.y() * step.y());
    t = std::max(t, kPeakSpeed * across / *limits[Limit::horizontal_speed]);
  }
  if (limits[Limit::vertical_speed])
    t = std::max(t, kPeakSpeed * std::abs(step.z()) / *limits[Limit::vertical_speed]);
  if (limits[Limit::acceleration]) t = std::max(t, accelerating(*limits[Limit::acceleration]));
  if (limits[Limit::thrust]) {
    t = std::max(t, accelerating(acceleration_within_thrust(*limits[Limit::thrust], step)));
  }
  if (limits[Limit::jerk]) t = std::max(t, cube_root(kPeakJerk * length / *limits[Limit::jerk]));
  if (limits[Limit::tilt])
    t = std::max(t, accelerating(acceleration_within(*limits[Limit::tilt], step)));
  return t > 0 ? t * (1 + 1e-9) : 1;
}

Segment straight(const Vec3& a, const Vec3& b, double duration) {
  return {duration, {a, a, a, a, b, b, b, b}, std::nullopt};
}

// Slowed until the thrust turns no faster than it may.
Segment turning_no_faster(const Segment& segment, const Limits& limits) {
  if (!limits[Limit::body_rate]) return segment;
  Limits turning;
  turning[Limit::body_rate] = limits[Limit::body_rate];
  const Trajectory alone{{segment}};
  return slowed(alone, smallest_factor(alone, turning)).segments.front();
}

}  // namespace

Trajectory stop_and_go(std::span<const Vec3> points, const Limits& limits) {
  assert(!points.empty());
  Trajectory trajectory;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Vec3& a = points[i - 1];
    const Vec3& b = points[i];
    if (a == b) continue;
    trajectory.segments.push_back(
        turning_no_faster(straight(a, b, shortest(b - a, limits)), limits));
  }
  if (trajectory.segments.empty()) {
    trajectory.segments.push_back(straight(points[0], points[0], 1));
  }
  return trajectory;
}

}  // namespace traj
