#pragma once

// From a path record to a trajectory record.
//
// Example:
//   const geom::PathRecord record{.id = "q1", .status = geom::PathStatus::found, .points = path};
//   const traj::SolvedRecord solved = traj::solve_record(scene, record, {.limits = limits});
//   std::cout << to_json_line(solved.record);

#include <optional>
#include <string>
#include <vector>

#include "geom/collision/collision.h"
#include "geom/record/record.h"
#include "traj/curve/yaw.h"
#include "traj/record/trajectory_record.h"
#include "traj/solve/min_snap.h"
#include "traj/solve/solve.h"

namespace traj {

// The record has the solver's report if it is solved. `limits` are those it was solved for.
TrajectoryRecord trajectory_record(const geom::CollisionScene& scene, std::string id,
                                   const SolveResult& result, const Limits& limits);

// The points, with the holds and velocities that the record gives.
std::vector<Waypoint> waypoints_of(const geom::PathRecord& path);

struct SolvedRecord {
  TrajectoryRecord record;
  Corridor corridor = {};  // of the optimiser
};

// The record of the trajectory along a path, with the path's times and bounds and, if asked for, a
// yaw. A path that was not found has no trajectory (without_path()).
SolvedRecord solve_record(const geom::CollisionScene& scene, const geom::PathRecord& path,
                          const SolveOptions& options, const std::optional<YawOptions>& yaw = {});

// The record that stands for a path that was not found: it says why in the path's words. `limits`
// are those that a trajectory would have been held to.
TrajectoryRecord without_path(const geom::PathRecord& path, const Limits& limits);

}  // namespace traj
