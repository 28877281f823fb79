#pragma once

// How far one attitude is from another.

#include <Eigen/Geometry>

#include "geom/base/vec3.h"

namespace traj {

using geom::Vec3;

// The rotation (radians about body axes, to first order twice the quaternion's vector) from `now`
// to `wanted`, with the part about the thrust axis made `yaw_weight` (0 to 1) of what it is: tilt
// comes first (Brescianini, Hehn and D'Andrea 2013, section IV).
Vec3 attitude_error(const Eigen::Quaterniond& now, const Eigen::Quaterniond& wanted,
                    double yaw_weight);

}  // namespace traj
