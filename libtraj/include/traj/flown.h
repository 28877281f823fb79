#pragma once

// What a file makes a vehicle fly, and whether that is clear of the map and within limits.

#include <optional>
#include <vector>

#include "geom/polyline.h"
#include "traj/check.h"
#include "traj/export/setpoints.h"
#include "traj/vertical_ends.h"

namespace traj {

// One of the two: a trajectory, or a path of straight legs with a rest at each point.
struct Flown {
  Trajectory trajectory;
  std::vector<Setpoint> setpoints;  // what the trajectory was drawn through: their limits count

  geom::Polyline path;
  std::vector<double> hold;  // s at each point of the path; may be empty
  VerticalEnds ends;
  std::optional<double> speed;  // m/s along the legs
  std::optional<FlightEnvelope> envelope;
  double airborne = 0;  // s, for the envelope
};

// A path with the ascent before and the descent after it, from 1 mm above where the vehicle stands:
// what check_flown looks at. Nothing for a take-off from above the path's beginning.
std::optional<geom::Polyline> whole_way(const geom::CollisionScene& scene, const Flown& flown);

// Single precision and six decimals: how far a file's segments may miss each other.
CheckOptions file_tolerance(const Limits& limits);

// traj::check of a trajectory, with file_tolerance: joints may miss by 1 mm, 1 cm/s, 0.1 m/s2,
// limits by 0.1%. Setpoints: collision and bounds of the straight ways between them, limits of each
// (a client that interpolates velocity and acceleration between them stays within). A path:
// check_path of its legs, with the ascent before and the descent after, from 1 mm above where the
// vehicle stands; then "speed", "horizontal_speed" and "vertical_speed" of its legs, and "ceiling",
// "range", "endurance". Times of a path count legs from 0, the ascent being one.
CheckResult check_flown(const geom::CollisionScene& scene, const Flown& flown,
                        const Limits& limits);

}  // namespace traj
