#pragma once

// Finite limits for solvers that need some, where the vehicle has none.

#include "traj/proof/limits.h"
#include "traj/solve/time_allocation.h"

namespace traj {

// The smallest of the speed limits, and of amax and the accelerations that keep tilt and thrust in
// any direction.
// A missing one follows from the other: the speed reached over half of `length` (metres, the whole
// path), or that speed reached in 1 s; 10 m/s when both are missing.
SpeedProfile nominal_profile(const Limits& limits, double length);

}  // namespace traj
