#include "traj/curve/trajectory.h"

#include <algorithm>

#include "curve/bernstein.h"

namespace traj {
namespace {

template <std::size_t N>
Vec3 value_at(std::array<Vec3, N> q, double u) {
  for (std::size_t n = N - 1; n > 0; --n) {
    for (std::size_t i = 0; i < n; ++i) q[i] = (1 - u) * q[i] + u * q[i + 1];
  }
  return q[0];
}

}  // namespace

double duration(const Trajectory& trajectory) {
  double sum = 0;
  for (const Segment& s : trajectory.segments) sum += s.duration;
  return sum;
}

State evaluate(const Segment& segment, double t) {
  const double u = std::clamp(t / segment.duration, 0.0, 1.0);
  return {value_at(segment.point, u), value_at(velocity_points(segment), u),
          value_at(acceleration_points(segment), u), value_at(jerk_points(segment), u)};
}

State evaluate(const Trajectory& trajectory, double t) {
  double begin = 0;
  for (const Segment& s : trajectory.segments) {
    if (t < begin + s.duration) return evaluate(s, t - begin);
    begin += s.duration;
  }
  const Segment& last = trajectory.segments.back();
  return evaluate(last, last.duration);
}

Segment hermite(const State& from, const State& to, double duration) {
  const double t = duration;
  // How far the points next to an end are from it; at the end time runs backwards.
  const auto offsets = [](const State& s, double h) {
    const Vec3 v = s.velocity * h / 7;
    const Vec3 a = s.acceleration * (h * h) / 42;
    const Vec3 j = s.jerk * (h * h * h) / 210;
    return std::array<Vec3, 3>{v, 2 * v + a, 3 * v + 3 * a + j};
  };
  const auto out = offsets(from, t);
  const auto in = offsets(to, -t);
  const Vec3& p = from.position;
  const Vec3& q = to.position;
  Segment segment;
  segment.duration = t;
  segment.point = {p, p + out[0], p + out[1], p + out[2], q + in[2], q + in[1], q + in[0], q};
  return segment;
}

}  // namespace traj
