#pragma once

// Finite limits for solvers that need some, where the vehicle has none.

#include <optional>

#include "solve/time_allocation.h"
#include "traj/proof/limits.h"

namespace traj {

// The smallest of the speed limits, and of amax and the accelerations that keep tilt and thrust in
// any direction.
// A missing one follows from the other: the speed reached over half of `length` (metres, the whole
// path), or that speed reached in 1 s; 10 m/s when both are missing.
SpeedProfile nominal_profile(const Limits& limits, double length);

// The same along one leg of a path, a vector in metres: where the limits across and upwards differ,
// each counts for its share of the direction, so a level leg is flown at the horizontal speed. A
// leg of no length, or whose speed nothing limits, has the profile given.
SpeedProfile along_leg(const Vec3& leg, const Limits& limits, const SpeedProfile& nominal);

// The same, or nothing where no limit holds the speed along the leg, or none the acceleration.
std::optional<SpeedProfile> cruise_profile(const Vec3& leg, const Limits& limits);

}  // namespace traj
