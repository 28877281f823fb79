#pragma once

// Trajectories as JSON Lines records.

#include <string>
#include <string_view>

#include "geom/record/record.h"
#include "geom/text/json_fields.h"
#include "traj/curve/trajectory.h"
#include "traj/proof/limits.h"

namespace traj {

struct TrajectoryRecord {
  std::string id;
  std::string status;  // "solved", "no_path" (there was nothing to solve) or "infeasible"
  Trajectory trajectory;
  geom::Provenance provenance;
  Limits limits;
  std::string message;  // why there is none, in words; may be empty
  std::string rung;     // what made it: "closed", "ipopt", "stop_and_go"; may be empty
  std::string solver;   // the solver's own report: a JSON object, or empty
};

// What holds for it: its own limits and its vehicle's.
Limits limits_of(const TrajectoryRecord& record);

std::string to_json_line(const TrajectoryRecord& record);  // ends with a newline

// Throws InputError(source, line, …) for anything that is not a trajectory record: malformed JSON,
// a missing key, a segment without 8 values an axis, a duration that is not positive and finite.
TrajectoryRecord parse_trajectory_record(std::string_view json, std::string_view source,
                                         std::size_t line);

}  // namespace traj
