#include "flight/attitude.h"

#include <cmath>

namespace traj {

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
