#pragma once

// Trajectory records: trajectories as JSON Lines.
//
// Example:
//   traj::TrajectoryRecord record{.id = "q1", .status = traj::TrajectoryStatus::solved};
//   record.trajectory = trajectory;
//   record.limits = limits;
//   const std::string line = traj::to_json_line(record);
//   const auto back = traj::parse_trajectory_record(line, "trajectories.jsonl", 1);
//   assert(traj::duration(back.trajectory) == traj::duration(trajectory));  // bit for bit

#include <optional>
#include <string>
#include <string_view>

#include "geom/record/record.h"
#include "traj/curve/trajectory.h"
#include "traj/proof/limits.h"
#include "traj/record/trajectory_status.h"
#include "traj/solve/rung.h"

namespace traj {

struct TrajectoryRecord {
  std::string id;
  TrajectoryStatus status = TrajectoryStatus::infeasible;
  Trajectory trajectory;
  geom::Provenance provenance;
  Limits limits;
  std::string message;       // why there is none, in words; may be empty
  std::optional<Rung> rung;  // what made it, where that is known
  std::string solver;        // the solver's own report: a JSON object, or empty
  // Claims (duration_bound.h). Metres: no path between its ends is shorter; seconds: no flight is.
  std::optional<double> bound;
  std::optional<double> duration_bound;
  geom::FlightTime time;
};

// The limits that hold for the record: the stricter of its own and its vehicle's.
Limits limits_of(const TrajectoryRecord& record);

std::string to_json_line(const TrajectoryRecord& record);  // ends with a newline

// Throws InputError(source, line, …) for anything that is not a trajectory record: malformed JSON,
// a missing key, a segment without 8 values an axis, a duration that is not positive and finite,
// and one of the whole that is not the sum of its segments (to 5 ms or a millionth).
TrajectoryRecord parse_trajectory_record(std::string_view json, std::string_view source,
                                         std::size_t line);
TrajectoryRecord read_trajectory_record(const geom::JsonFields& fields);

}  // namespace traj
