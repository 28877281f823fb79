#include "solve/time_allocation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace traj {
namespace {

// The largest speed around a corner between unit directions: an arc of radius r that stays within
// d of the corner has r = d s / (1 - s), s the sine of half the inner angle.
double corner_speed(const Vec3& in, const Vec3& out, double vmax, const Turns& turns) {
  const double s = std::sqrt(std::clamp((1 + in.dot(out)) / 2, 0.0, 1.0));
  const double reach = turns.acceleration * turns.deviation * s;
  if (reach >= vmax * vmax * (1 - s)) return vmax;
  return std::sqrt(reach / (1 - s));
}

}  // namespace

double leg_time(double length, double from, double to, const SpeedProfile& profile) {
  const double a = profile.amax;
  const double peak_square = a * length + (from * from + to * to) / 2;
  const double peak = std::max({std::min(std::sqrt(peak_square), profile.vmax),
                                std::min(from, profile.vmax), std::min(to, profile.vmax)});
  const double ramps =
      std::max(0.0, peak * peak - from * from) + std::max(0.0, peak * peak - to * to);
  const double cruise = std::max(0.0, length - ramps / (2 * a));
  if (peak <= 0) return 0;
  if (cruise == 0 && std::max(from, to) >= peak) return 2 * length / (from + to);
  return std::max(0.0, peak - from) / a + std::max(0.0, peak - to) / a + cruise / peak;
}

std::vector<double> even_times(std::span<const Vec3> points, double speed) {
  std::vector<double> times;
  for (std::size_t i = 1; i < points.size(); ++i) {
    times.push_back((points[i] - points[i - 1]).norm() / speed);
  }
  return times;
}

std::vector<double> turn_radii(std::span<const Vec3> points) {
  const double straight_on = std::numeric_limits<double>::infinity();
  std::vector<double> radii(points.size(), straight_on);
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const Vec3 in = points[i] - points[i - 1];
    const Vec3 out = points[i + 1] - points[i];
    const double a = in.norm();
    const double b = out.norm();
    const double across = in.cross(out).norm();
    const double along = a * b + in.dot(out);
    if (across == 0 && along > 0) continue;
    if (a == 0 || b == 0) continue;
    // tan(turn / 2) = across / along.
    radii[i] = along <= 0 ? 0 : std::min(a, b) / 2 * along / across;
  }
  return radii;
}

std::vector<double> cautious_times(std::span<const Vec3> points, std::span<const double> clearances,
                                   const Caution& caution) {
  assert(clearances.size() + 1 == points.size());
  const std::vector<double> radii = turn_radii(points);
  std::vector<double> times;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double radius = std::min(radii[i - 1], radii[i]);
    const double closeness = std::min(1.0, clearances[i - 1] / caution.comfortable);
    const double speed = std::min(caution.cruise, std::sqrt(caution.amax * radius)) * closeness;
    times.push_back((points[i] - points[i - 1]).norm() /
                    std::max(speed, caution.least * caution.cruise));
  }
  return times;
}

std::vector<double> stopping_times(std::span<const Vec3> points, const SpeedProfile& profile) {
  std::vector<double> times;
  for (std::size_t i = 1; i < points.size(); ++i) {
    times.push_back(leg_time((points[i] - points[i - 1]).norm(), 0, 0, profile));
  }
  return times;
}

std::vector<double> corner_speeds(std::span<const Vec3> points, std::span<const SpeedProfile> legs,
                                  const Turns& turns) {
  const std::size_t n = points.size();
  assert(legs.size() + 1 == n);
  std::vector<double> speed(n, 0.0);
  speed.front() = turns.first;
  speed.back() = turns.last;
  const auto leg = [&](std::size_t i) { return Vec3(points[i + 1] - points[i]); };
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double vmax = std::min(legs[i - 1].vmax, legs[i].vmax);
    speed[i] = corner_speed(leg(i - 1).normalized(), leg(i).normalized(), vmax, turns);
  }
  if (turns.within_legs) {
    const std::vector<double> radii = turn_radii(points);
    for (std::size_t i = 1; i + 1 < n; ++i) {
      speed[i] = std::min(speed[i], std::sqrt(turns.acceleration * radii[i]));
    }
  }
  const auto reachable = [&](double v, std::size_t i) {
    return std::sqrt(v * v + 2 * legs[i].amax * leg(i).norm());
  };
  for (std::size_t i = 1; i < n; ++i) {
    speed[i] = std::min(speed[i], reachable(speed[i - 1], i - 1));
  }
  for (std::size_t i = n; i-- > 1;) {
    speed[i - 1] = std::min(speed[i - 1], reachable(speed[i], i - 1));
  }
  return speed;
}

std::vector<double> rolling_times(std::span<const Vec3> points, std::span<const double> speeds,
                                  std::span<const SpeedProfile> legs) {
  assert(speeds.size() == points.size() && legs.size() + 1 == points.size());
  std::vector<double> times;
  for (std::size_t i = 1; i < points.size(); ++i) {
    times.push_back(
        leg_time((points[i] - points[i - 1]).norm(), speeds[i - 1], speeds[i], legs[i - 1]));
  }
  return times;
}

}  // namespace traj
