#pragma once

// The part of the proof that holds a trajectory against its limits.

#include "traj/proof/check.h"

namespace traj {

// Fills in the largest value of each limited quantity, and the reason of the first limit that is
// not shown to hold, unless there is a reason already.
void check_limits(const Trajectory& trajectory, const CheckOptions& options, CheckResult& result);

}  // namespace traj
