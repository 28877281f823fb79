#pragma once

// A lower bound on the time of a flight, from the distance between its ends and its limits.

#include <optional>

#include "geom/base/vec3.h"
#include "traj/proof/limits.h"

namespace traj {

// Two places, and a lower bound on the length of every path between them, metres.
struct Stretch {
  geom::Vec3 from = geom::Vec3::Zero();
  geom::Vec3 to = geom::Vec3::Zero();
  double length = 0;  // >= 0
};

// Seconds: no motion over the stretch lasts less if it is at rest at both ends, has a continuous
// velocity and keeps the limits. Never above the real least time: every step is rounded down. On
// a straight line, with limits on speed and acceleration alone, it is that time. Uses the limits on
// speeds, acceleration, thrust and tilt; jerk, body rate and yaw rate could only make it longer.
// Nothing where there is nothing to bridge, where these limit nothing, and where a limit cannot be
// judged (domain.h). docs/bound.md has the proof.
std::optional<double> least_duration(const Stretch& stretch, const Limits& limits);

}  // namespace traj
