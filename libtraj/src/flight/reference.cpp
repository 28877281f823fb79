#include "traj/flight/reference.h"

#include <algorithm>

#include "curve/bernstein.h"

namespace traj {
namespace {

template <class T, std::size_t N>
T value_at(std::array<T, N> q, double u) {
  for (std::size_t n = N - 1; n > 0; --n) {
    for (std::size_t i = 0; i < n; ++i) q[i] += u * (q[i + 1] - q[i]);
  }
  return q[0];
}

}  // namespace

ReferenceTrack::ReferenceTrack(const Trajectory& trajectory) {
  pieces_.reserve(trajectory.segments.size());
  for (const Segment& s : trajectory.segments) {
    Piece piece{duration_,
                s.duration,
                s.point,
                velocity_points(s),
                acceleration_points(s),
                jerk_points(s),
                s.yaw.value_or(std::array<double, 8>{}),
                {}};
    for (int i = 0; i + 1 < kPoints; ++i) {
      piece.yaw_rate[i] = kDegree * (piece.yaw[i + 1] - piece.yaw[i]) / s.duration;
    }
    pieces_.push_back(piece);
    duration_ += s.duration;
  }
}

Reference ReferenceTrack::at(double t, std::size_t& cursor) const {
  if (cursor >= pieces_.size() || t < pieces_[cursor].begin) cursor = 0;
  while (cursor + 1 < pieces_.size() && t >= pieces_[cursor + 1].begin) ++cursor;
  const Piece& p = pieces_[cursor];
  const double u = std::clamp((t - p.begin) / p.duration, 0.0, 1.0);
  Reference out;
  out.position = value_at(p.position, u);
  out.yaw = value_at(p.yaw, u);
  if (t < 0 || t > duration_) return out;
  out.velocity = value_at(p.velocity, u);
  out.acceleration = value_at(p.acceleration, u);
  out.jerk = value_at(p.jerk, u);
  out.yaw_rate = value_at(p.yaw_rate, u);
  return out;
}

}  // namespace traj
