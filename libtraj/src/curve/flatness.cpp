#include "traj/curve/flatness.h"

#include <algorithm>
#include <cmath>

#include "geom/vehicle/limits.h"

namespace traj {
namespace {

constexpr double kFreeFall = 1e-9;  // m/s2
constexpr double kSideways = 1e-9;  // of 1: what is left of the x axis there is rounding

// Horizontally to the left of the heading: the x axis is across it and z.
Vec3 left_of(double yaw) { return {-std::sin(yaw), std::cos(yaw), 0}; }

Eigen::Matrix3d upright(double yaw) {
  return Eigen::AngleAxisd(yaw, Vec3::UnitZ()).toRotationMatrix();
}

}  // namespace

Eigen::Matrix3d attitude_along(const Vec3& force, double yaw) {
  const Vec3 z = force.normalized();
  const Vec3 across = left_of(yaw).cross(z);
  const double size = across.norm();
  const Vec3 x = size > kSideways ? Vec3(across / size) : Vec3(std::cos(yaw), std::sin(yaw), 0);
  Eigen::Matrix3d attitude;
  attitude << x, z.cross(x), z;
  return attitude;
}

Vec3 body_rates_along(const Vec3& force, const Vec3& jerk, const Heading& heading) {
  const Eigen::Matrix3d attitude = attitude_along(force, heading.yaw);
  const Vec3 y = attitude.col(1);
  const Vec3 z = attitude.col(2);
  const Vec3 dz = (jerk - z * z.dot(jerk)) / force.norm();
  const Vec3 left = left_of(heading.yaw);
  const Vec3 dleft = heading.rate * Vec3(-std::cos(heading.yaw), -std::sin(heading.yaw), 0);
  const double size = left.cross(z).norm();
  const Vec3 dacross = dleft.cross(z) + left.cross(dz);
  // From R' = R [w]x: y . z' = -p, x . z' = q, y . x' = r.
  return {-dz.dot(y), dz.dot(attitude.col(0)), size > kSideways ? dacross.dot(y) / size : 0};
}

FlatState flat_state(const State& state, const Heading& heading) {
  const Vec3 force = state.acceleration + Vec3(0, 0, geom::kGravity);
  const double thrust = force.norm();
  if (thrust < kFreeFall) return {upright(heading.yaw), thrust, {0, 0, heading.rate}};
  return {attitude_along(force, heading.yaw), thrust, body_rates_along(force, state.jerk, heading)};
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
