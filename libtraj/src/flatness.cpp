#include "traj/flatness.h"

#include <algorithm>
#include <cmath>

#include "traj/limits.h"

namespace traj {
namespace {

constexpr double kFreeFall = 1e-9;  // m/s2

Eigen::Matrix3d upright(double yaw) {
  return Eigen::AngleAxisd(yaw, Vec3::UnitZ()).toRotationMatrix();
}

// The value and the derivative in u of a polynomial of degree 7 by its Bernstein values.
Heading on_segment(std::array<double, kPoints> b, double u, double duration) {
  for (int m = kDegree; m > 1; --m) {
    for (int i = 0; i < m; ++i) b[i] += u * (b[i + 1] - b[i]);
  }
  const double step = b[1] - b[0];
  return {b[0] + u * step, kDegree * step / duration};
}

}  // namespace

FlatState flat_state(const State& state, const Heading& heading) {
  const Vec3 force = state.acceleration + Vec3(0, 0, kGravity);
  const double thrust = force.norm();
  if (thrust < kFreeFall) return {upright(heading.yaw), thrust, {0, 0, heading.rate}};
  const Vec3 z = force / thrust;
  const Vec3 dz = (state.jerk - z * z.dot(state.jerk)) / thrust;
  // Left of the heading on the ground, and its derivative; x is across it and z.
  const Vec3 left(-std::sin(heading.yaw), std::cos(heading.yaw), 0);
  const Vec3 dleft = heading.rate * Vec3(-std::cos(heading.yaw), -std::sin(heading.yaw), 0);
  const Vec3 across = left.cross(z);
  const Vec3 x = across.normalized();
  const Vec3 y = z.cross(x);
  const Vec3 dacross = dleft.cross(z) + left.cross(dz);
  FlatState out;
  out.attitude << x, y, z;
  out.thrust = thrust;
  // From R' = R [w]x: y . z' = -p, x . z' = q, y . x' = r.
  out.body_rate = {-dz.dot(y), dz.dot(x), dacross.dot(y) / across.norm()};
  return out;
}

State to_enu(geom::Axes axes, const State& s) {
  return {geom::to_enu(axes, s.position), geom::to_enu(axes, s.velocity),
          geom::to_enu(axes, s.acceleration), geom::to_enu(axes, s.jerk)};
}

Heading heading_at(const Trajectory& trajectory, geom::Axes axes, double t) {
  const Segment* segment = nullptr;
  double begin = 0;
  for (const Segment& s : trajectory.segments) {
    if (segment) begin += segment->duration;
    segment = &s;
    if (t < begin + s.duration) break;
  }
  const double u = std::clamp((t - begin) / segment->duration, 0.0, 1.0);
  const Heading own = on_segment(*segment->yaw, u, segment->duration);
  return {geom::yaw_to_enu(axes, own.yaw), axes == geom::Axes::enu ? own.rate : -own.rate};
}

}  // namespace traj
