#pragma once

// A hash of the numbers that a check looked at, for its report.
//
// Example:
//   traj::TrajectoryRecord other = {.id = "q1", .trajectory = trajectory};
//   const std::string hash = traj::checked_hash(other);
//   other.trajectory.segments.front().duration *= 2;  // with the same id
//   assert(traj::checked_hash(other) != hash);

#include <string>

#include "geom/record/record.h"
#include "traj/flight/flight_log.h"
#include "traj/record/trajectory_record.h"

namespace traj {

// SHA-256, in hexadecimal, over what decides where the vehicle is; ids, limits and maps say nothing
// of that. Of a trajectory its trajectory_hash(). Of a path the number of its points and their
// coordinates, of a log the number of its samples and, of each, its time and its position: as
// little-endian float64. -0 counts as 0.
std::string checked_hash(const TrajectoryRecord& record);
std::string checked_hash(const geom::PathRecord& record);
std::string checked_hash(const FlightLog& log);

}  // namespace traj
