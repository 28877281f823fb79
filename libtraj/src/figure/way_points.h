#pragma once

// Points along ways, close enough that lines between them look like curves.

#include <vector>

#include "traj/curve/trajectory.h"

namespace traj::figure {

// `step`, or more where `extent` has very many of these.
double step_of(double extent, double step);

inline constexpr double kSecondsBetween = 0.05;

// At least two.
std::vector<Vec3> points_of(const Trajectory& trajectory);

}  // namespace traj::figure
