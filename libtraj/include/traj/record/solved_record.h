#pragma once

// Trajectory records of what was solved, and waypoints of the path records that it is solved from.
//
// Example:
//   const traj::SolveResult flight = traj::solve(scene, path, {.limits = limits});
//   std::cout << to_json_line(traj::trajectory_record(scene, "q1", flight, limits));

#include <string>
#include <vector>

#include "geom/collision/collision.h"
#include "geom/record/record.h"
#include "traj/record/trajectory_record.h"
#include "traj/solve/min_snap.h"
#include "traj/solve/solve.h"

namespace traj {

// With the solver's report where it is solved. `limits` are those it was solved for.
TrajectoryRecord trajectory_record(const geom::CollisionScene& scene, std::string id,
                                   const SolveResult& result, const Limits& limits);

// The points, with the holds and velocities that the record gives.
std::vector<Waypoint> waypoints_of(const geom::PathRecord& path);

}  // namespace traj
