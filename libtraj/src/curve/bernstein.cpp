#include "curve/bernstein.h"

#include "halves.h"
#include "hermite_form.h"

namespace traj {
namespace {

template <std::size_t N>
std::array<Vec3, N - 1> derivative(const std::array<Vec3, N>& q, double duration) {
  std::array<Vec3, N - 1> d;
  const double degree = static_cast<double>(N - 1);
  for (std::size_t i = 0; i + 1 < N; ++i) d[i] = (q[i + 1] - q[i]) * degree / duration;
  return d;
}

}  // namespace

std::array<Vec3, 7> velocity_points(const Segment& segment) {
  return derivative(segment.point, segment.duration);
}

std::array<Vec3, 6> acceleration_points(const Segment& segment) {
  return derivative(velocity_points(segment), segment.duration);
}

std::array<Vec3, 5> jerk_points(const Segment& segment) {
  return derivative(acceleration_points(segment), segment.duration);
}

std::pair<Segment, Segment> split(const Segment& segment) {
  const auto [left, right] = halves(segment.point);
  std::pair<Segment, Segment> out;
  out.first = {0.5 * segment.duration, left, std::nullopt};
  out.second = {0.5 * segment.duration, right, std::nullopt};
  if (segment.yaw) {
    const auto [yaw_left, yaw_right] = halves(*segment.yaw);
    out.first.yaw = yaw_left;
    out.second.yaw = yaw_right;
  }
  return out;
}

double snap_cost(const Segment& segment) {
  const auto snap = derivative(jerk_points(segment), segment.duration);
  double sum = 0;
  for (std::size_t i = 0; i < snap.size(); ++i) {
    for (std::size_t j = 0; j < snap.size(); ++j) sum += kSnapGram[i][j] * snap[i].dot(snap[j]);
  }
  return sum / kSnapGramUnit * segment.duration;
}

double snap_cost(const Trajectory& trajectory) {
  double sum = 0;
  for (const Segment& s : trajectory.segments) sum += snap_cost(s);
  return sum;
}

}  // namespace traj
