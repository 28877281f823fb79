#include "traj/curve/smoothness.h"

#include <algorithm>
#include <array>

#include "bernstein.h"

namespace traj {
namespace {

// Control points of the snap, of degree 3.
std::array<Vec3, 4> snap_points(const Segment& segment) {
  const std::array<Vec3, 5> jerk = jerk_points(segment);
  std::array<Vec3, 4> out;
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i] = 4 / segment.duration * (jerk[i + 1] - jerk[i]);
  }
  return out;
}

constexpr double choose(std::size_t n, std::size_t k) {
  double out = 1;
  for (std::size_t i = 1; i <= k; ++i)
    out *= static_cast<double>(n - k + i) / static_cast<double>(i);
  return out;
}

// The integral of the square of the polynomial with these Bernstein points over its duration: the
// product of two basis polynomials of degree n is one of degree 2 n, times a quotient of binomials.
template <std::size_t N>
double squared_integral(const std::array<Vec3, N>& point, double duration) {
  constexpr std::size_t n = N - 1;
  double sum = 0;
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t j = 0; j < N; ++j) {
      sum += choose(n, i) * choose(n, j) / choose(2 * n, i + j) * point[i].dot(point[j]);
    }
  }
  return duration / static_cast<double>(2 * n + 1) * sum;
}

}  // namespace

Vec3 snap(const Trajectory& trajectory, double t) {
  const Segment* segment = &trajectory.segments.front();
  for (std::size_t i = 1; i < trajectory.segments.size() && t >= segment->duration; ++i) {
    t -= segment->duration;
    segment = &trajectory.segments[i];
  }
  const double u = std::clamp(t / segment->duration, 0.0, 1.0);
  std::array<Vec3, 4> point = snap_points(*segment);
  for (std::size_t left = point.size() - 1; left > 0; --left) {  // de Casteljau
    for (std::size_t i = 0; i < left; ++i) point[i] += u * (point[i + 1] - point[i]);
  }
  return point[0];
}

Smoothness smoothness(const Trajectory& trajectory) {
  Smoothness out{0, snap_cost(trajectory)};
  for (const Segment& segment : trajectory.segments) {
    out.jerk += squared_integral(jerk_points(segment), segment.duration);
  }
  return out;
}

}  // namespace traj
