#include "traj/curve/flatness.h"

#include <algorithm>
#include <cmath>

#include "traj/proof/limits.h"

namespace traj {
namespace {

constexpr double kFreeFall = 1e-9;  // m/s2

Eigen::Matrix3d upright(double yaw) {
  return Eigen::AngleAxisd(yaw, Vec3::UnitZ()).toRotationMatrix();
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

Heading heading_at(const Trajectory& trajectory, geom::Axes axes, double t) {
  const Segment* segment = nullptr;
  double begin = 0;
  for (const Segment& s : trajectory.segments) {
    if (segment) begin += segment->duration;
    segment = &s;
    if (t < begin + s.duration) break;
  }
  const double u = std::clamp((t - begin) / segment->duration, 0.0, 1.0);
  const Heading own = *heading(*segment, u);
  return {geom::yaw_to_enu(axes, own.yaw), axes == geom::Axes::enu ? own.rate : -own.rate};
}

}  // namespace traj
