#include "traj/flight/attitude.h"

#include <algorithm>
#include <cmath>

namespace traj {

Eigen::Quaterniond attitude_along(const Vec3& thrust, double yaw) {
  const Vec3 z = thrust.normalized();
  const Vec3 ahead(std::cos(yaw), std::sin(yaw), 0);
  Vec3 y = z.cross(ahead);
  const double size = y.norm();
  // Straight along the heading: pitched by a quarter turn, the y axis stays level.
  y = size > 1e-9 ? Vec3(y / size) : Vec3(-ahead.y(), ahead.x(), 0);
  Eigen::Matrix3d rotation;
  rotation << y.cross(z), y, z;
  return Eigen::Quaterniond(rotation);
}

Vec3 body_rates_along(const Eigen::Quaterniond& attitude, double f, const Vec3& jerk,
                      double yaw_rate) {
  const Eigen::Matrix3d rotation = attitude.toRotationMatrix();
  const Vec3 turn = (jerk - rotation.col(2).dot(jerk) * rotation.col(2)) / f;
  return {-turn.dot(rotation.col(1)), turn.dot(rotation.col(0)), yaw_rate * rotation(2, 2)};
}

Vec3 attitude_error(const Eigen::Quaterniond& now, const Eigen::Quaterniond& wanted,
                    double yaw_weight) {
  const Vec3 z = now * Vec3::UnitZ();
  const Vec3 z_wanted = wanted * Vec3::UnitZ();
  const Eigen::Quaterniond tilted = Eigen::Quaterniond::FromTwoVectors(z, z_wanted) * now;
  const Eigen::Quaterniond rest = tilted.conjugate() * wanted;  // about the thrust axis
  const double angle = 2 * std::atan2(rest.z(), rest.w());
  const double about = std::remainder(angle, 6.283185307179586) * yaw_weight;
  const Eigen::Quaterniond aim = tilted * Eigen::AngleAxisd(about, Vec3::UnitZ());
  const Eigen::Quaterniond error = now.conjugate() * aim;
  return (error.w() < 0 ? -2 : 2) * error.vec();
}

}  // namespace traj
