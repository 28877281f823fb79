#pragma once

// Setpoints held against a map and limits, as a client sends them.

#include <vector>

#include "traj/curve/setpoint.h"
#include "traj/proof/check.h"

namespace traj {

// Of setpoints as judge.h says: at least two, with times that grow.
CheckResult check_setpoints(const geom::CollisionScene& scene,
                            const std::vector<Setpoint>& setpoints, const Limits& limits,
                            Clearance clearance);

}  // namespace traj
