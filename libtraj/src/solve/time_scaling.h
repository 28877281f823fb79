#pragma once

// One factor on all durations: the exact way to make the limits just hold.

#include "traj/curve/trajectory.h"
#include "traj/proof/limits.h"

namespace traj {

// The same curve, flown `factor` (> 0) times as slowly.
Trajectory slowed(const Trajectory& trajectory, double factor);

// The smallest factor with which slowed() obeys all limits: never below the real one, and at most
// a relative 1e-6 above, unless body_rate asks for more. 1 when there is no limit or nothing moves.
double smallest_factor(const Trajectory& trajectory, const Limits& limits);

}  // namespace traj
