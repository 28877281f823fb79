#pragma once

// The trajectory that exists for every free path: straight along each leg, resting at each point.

#include <span>

#include "traj/curve/trajectory.h"
#include "traj/proof/limits.h"

namespace traj {

// One segment a leg of positive length, with control points a, a, a, a, b, b, b, b bit for bit: it
// never leaves the leg, and v = a = j = 0 at both ends. Each takes the shortest time that obeys the
// limits to a relative 1e-9 (1 s when there are none). A path of one place rests there for 1 s.
// At least one point.
Trajectory stop_and_go(std::span<const Vec3> points, const Limits& limits);

}  // namespace traj
