#pragma once

// How much faster than a trajectory record any other flight could be.
//
// Example:
//   traj::TrajectoryRecord record{.id = "q1", .trajectory = trajectory, .limits = limits};
//   record.bound = 8;  // metres: no path between its ends is shorter
//   const auto least = traj::duration_bound(record, limits);
//   assert(*least < traj::duration(trajectory));
//   std::cout << traj::slower_words(*traj::duration_gap(record)) << '\n';
//
// All of it rests on the bound on length in the record, which this library cannot verify.

#include <optional>
#include <string>

#include "geom/record/record.h"
#include "traj/record/trajectory_record.h"

namespace traj {

// Seconds: least_duration() between the record's ends, for its bound on length. Nothing without
// such a bound, and where the record does not begin and end at rest.
std::optional<double> duration_bound(const TrajectoryRecord& record, const Limits& limits);

// Takes over the path's bound on length, and with it the one on the duration, where both hold for
// the record: it is solved, of the same map, frame, vehicle and margin, and has the path's ends.
void add_bounds(const geom::PathRecord& path, TrajectoryRecord& record);

// Whether the record claims the impossible: a duration bound that does not follow from its bound
// on length and its limits; a bound on length that is longer than its own curve, or from which a
// time follows that it undercuts itself. Call it for a free trajectory within its limits.
bool claims_too_much(const TrajectoryRecord& record);

// The same of a record that keeps these limits, too.
bool claims_too_much(const TrajectoryRecord& record, const Limits& limits);

// Whether the path is shorter than its own bound on length. Call it for a free path.
bool claims_too_much(const geom::PathRecord& path);

// The record's duration over duration_bound() for its own limits, less 1. Nothing if there is no
// such bound, or if the record claims too much.
std::optional<double> duration_gap(const TrajectoryRecord& record);

// "at most 3.2 % slower than any", of duration / bound - 1; rounded up.
std::string slower_words(double gap);

}  // namespace traj
