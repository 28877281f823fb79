#pragma once

// How well the segments of a trajectory meet.

#include <array>

#include "traj/curve/trajectory.h"

namespace traj {

// The largest jump of the d-th derivative over all joints, d = 0 to 6 (m/s^d, Euclidean norm), from
// the control points as they stand; 0 for one segment. Those above jerk need not be small: they are
// for least snap without holds or given derivatives.
std::array<double, 7> largest_jumps(const Trajectory& trajectory);

}  // namespace traj
