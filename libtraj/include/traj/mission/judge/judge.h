#pragma once

// Whether what a vehicle flies when it gets a file is clear of the map and within limits.
//
// Example:
//   traj::FlownLegs legs;
//   legs.path = path;
//   legs.ends.takeoff_from = 0;
//   assert(traj::judge(scene, {legs}, limits).ok);

#include <optional>

#include "traj/mission/flown/flown.h"
#include "traj/proof/check.h"

namespace traj {

// A path with the ascent before and the descent after it, from 1 mm above where the vehicle stands:
// what judge() looks at. Nothing for a take-off from above the path's beginning.
std::optional<geom::Polyline> whole_way(const geom::CollisionScene& scene, const FlownLegs& legs);

// Single precision and six decimals: how far a file's segments may miss each other.
CheckOptions file_tolerance(const Limits& limits);

// A curve: traj::check with file_tolerance: joints may miss by 1 mm, 1 cm/s, 0.1 m/s2,
// limits by 0.1%.
// Setpoints: a client that goes straight from position to position, and interpolates velocity and
// acceleration in between, sent in single precision. Collision and bounds of the straight ways;
// limits of each setpoint and of the changes from one to the next: the speed of the way, the
// acceleration that changes the velocity, the jerk and the turning of the thrust as the
// acceleration changes, the yaw rate. So a file whose columns contradict each other is
// refused.
// Legs: check_path of them, with the ascent before and the descent after, from 1
// mm above where the vehicle stands; of a mission its sweeps (check_sweeps), its drift
// (check_drift), and its fences too; below each
// rally place must be the ground of home, or the way back is not known ("return"), and below each
// place that it sinks from ("landing"); then "speed",
// "horizontal_speed" and "vertical_speed" of its legs where the speed is known, "ceiling", "range",
// "endurance", and "return" where it ends by a way that is not said. How a vehicle speeds up and
// slows down along legs is not measured. Times of a path count legs from 0, the
// ascent being one.
//
// Then the same for a vehicle that is larger by `navigation`, without the margin, which is there
// for such (a mission's drift has it already): `strayed` says what was refused there.
CheckResult judge(const geom::CollisionScene& scene, const Flown& flown, const Limits& limits,
                  Clearance clearance = Clearance::measured);

}  // namespace traj
