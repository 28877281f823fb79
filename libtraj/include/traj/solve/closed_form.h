#pragma once

// Least snap through waypoints, with leg times from the limits: no optimiser, not yet proved.
//
// Example:
//   const std::vector<traj::Waypoint> waypoints = traj::waypoints_at(path);
//   const auto flight = traj::closed_form(scene, waypoints, limits, traj::Times::stops);
//   assert(flight && traj::check(scene, *flight, limits).ok);  // the check decides

#include <optional>
#include <span>
#include <vector>

#include "geom/collision/collision.h"
#include "traj/proof/limits.h"
#include "traj/solve/min_snap.h"

namespace traj {

// How leg times follow from the limits (nominal_profile makes them a speed v and an acceleration
// a). stops: as if every waypoint were one. distance: length / (v / 5). cautious: at most at 16/35
// v, slower near turns, obstacles and bounds (cautious_times, comfortable where v can be braked to
// nothing, never below a quarter). trapezoid: rolling at a / 2 through turns that are cut by 0.5 m.
enum class Times { stops, distance, cautious, trapezoid };

// Seconds a leg, one fewer than points; 0 for a leg of no length.
std::vector<double> leg_times(const geom::CollisionScene& scene, std::span<const Vec3> points,
                              const Limits& limits, Times times);

// min_snap with these times, all of them multiplied by the factor with which the limits just hold;
// by none below 1 for distance and cautious, which say how fast to fly. Only the velocities that
// are given are kept, not accelerations, jerks or holds. Nothing if no such factor is found, which
// happens only with given velocities. At least one waypoint.
std::optional<Trajectory> closed_form(const geom::CollisionScene& scene,
                                      std::span<const Waypoint> waypoints, const Limits& limits,
                                      Times times);

}  // namespace traj
