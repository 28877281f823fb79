#pragma once

// Attitudes from thrust directions, and how far one attitude is from another.

#include <Eigen/Geometry>

#include "geom/shape/vec3.h"

namespace traj {

using geom::Vec3;

// The attitude whose z axis is along `thrust` (not zero) and whose x axis points towards `yaw`
// (radians from east) as far as that allows: Mellinger and Kumar 2011, eq. 7 to 9. Where the thrust
// is along that direction itself, the x axis is down.
Eigen::Quaterniond attitude_along(const Vec3& thrust, double yaw);

// The body rates with which attitude_along() follows a thrust over mass `f` (m/s2) that changes by
// `jerk` (m/s3) while the yaw turns by `yaw_rate`: Mellinger and Kumar 2011, section III.
Vec3 body_rates_along(const Eigen::Quaterniond& attitude, double f, const Vec3& jerk,
                      double yaw_rate);

// The rotation (radians about body axes, to first order twice the quaternion's vector) from `now`
// to `wanted`, with the part about the thrust axis made `yaw_weight` (0 to 1) of what it is: tilt
// comes first (Brescianini, Hehn and D'Andrea 2013, section IV).
Vec3 attitude_error(const Eigen::Quaterniond& now, const Eigen::Quaterniond& wanted,
                    double yaw_weight);

}  // namespace traj
