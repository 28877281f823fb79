#pragma once

// The flight of a vehicle that gets a file, and the check of that flight.
//
// Example:
//   traj::Flown flown;
//   flown.path = path;
//   flown.ends.takeoff_from = 0;  // from the ground, straight up
//   assert(traj::check_flown(scene, flown, {}).ok);

#include <optional>
#include <vector>

#include "geom/shape/polyline.h"
#include "traj/curve/setpoint.h"
#include "traj/curve/vertical_ends.h"
#include "traj/proof/check.h"
#include "traj/proof/sweep.h"

namespace traj {

// One of the two: a trajectory, or a path of straight legs with a rest at each point.
struct Flown {
  Trajectory trajectory;
  std::vector<Stray> stray;         // of its segments, from the drone's own rounding; may be empty
  std::vector<Setpoint> setpoints;  // what the trajectory was drawn through: their limits count

  geom::Polyline path;
  std::vector<double> hold;  // s at each point of the path; may be empty
  VerticalEnds ends;
  bool lands_below = false;        // on whatever is below the last point
  Vec3 path_stray = Vec3::Zero();  // m that the flight may be from the path, along each axis
  std::optional<double> speed;     // m/s along the legs
  double climb = 0;                // m/s at most, whatever that speed is; 0: as it is
  double descent = 0;              // likewise
  std::vector<FlightPart> legs;    // of a mission: to each point, and the landing's; may be empty
  std::vector<Sweep> sweeps;       // beside the path
  std::vector<Drift> drift;        // where the autopilots that may fly it may be
  // m along each axis that the vehicle may be off all this: how wrong it is about its place, and,
  // if there is no drift, how far it strays in tracking.
  Vec3 navigation = Vec3::Zero();
  std::vector<Vec3> rally;        // places in the air from which it may land instead
  std::vector<Vec3> touches;      // places in the air from which it sinks to the ground on its way
  std::vector<Fence> fences;      // that the path and the sweeps keep to
  std::optional<Vec3> home;       // that was assumed
  std::size_t idle_items = 0;     // that move nothing
  std::size_t endless_jumps = 0;  // jumps for ever, taken twice
  std::size_t corners = 0;        // points of a mission that it passes without a rest
  double acceptance = 0;          // m around these, the most that was swept
  bool returns = false;           // it goes on to a return to home, by a way that is not said
  std::optional<FlightEnvelope> envelope;
  double airborne = 0;  // s, for the envelope
};

// A path with the ascent before and the descent after it, from 1 mm above where the vehicle stands:
// what check_flown looks at. Nothing for a take-off from above the path's beginning.
std::optional<geom::Polyline> whole_way(const geom::CollisionScene& scene, const Flown& flown);

// Single precision and six decimals: how far a file's segments may miss each other.
CheckOptions file_tolerance(const Limits& limits);

// traj::check of a trajectory, with file_tolerance: joints may miss by 1 mm, 1 cm/s, 0.1 m/s2,
// limits by 0.1%.
// Setpoints: a client that goes straight from position to position, and interpolates velocity and
// acceleration in between, sent in single precision. Collision and bounds of the straight ways;
// limits of each setpoint and of the changes from one to the next: the speed of the way, the
// acceleration that changes the velocity, the jerk and the turning of the thrust as the
// acceleration changes, the yaw rate. So a file whose columns contradict each other is
// refused. A path: check_path of its legs, with the ascent before and the descent after, from 1
// mm above where the vehicle stands, of its sweeps (check_sweeps), its drift (check_drift), and
// its fences; below each
// rally place must be the ground of home, or the way back is not known ("return"), and below each
// place that it sinks from ("landing"); then "speed",
// "horizontal_speed" and "vertical_speed" of its legs where the speed is known, "ceiling", "range",
// "endurance", and "return" where it ends by a way that is not said. How a vehicle speeds up and
// slows down along legs is not measured. Times of a path count legs from 0, the
// ascent being one.
//
// Then the same for a vehicle that is larger by `navigation`, without the margin, which is there
// for such (a mission's drift has it already): `strayed` says what was refused there.
CheckResult check_flown(const geom::CollisionScene& scene, const Flown& flown, const Limits& limits,
                        Clearance clearance = Clearance::measured);

}  // namespace traj
