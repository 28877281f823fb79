#pragma once

// The trajectories of a folder held against one another: its files of pairs, and what they say.
//
// Example:
//   traj::TrajectoryRecord record{.id = "q1", .status = traj::TrajectoryStatus::solved};
//   record.trajectory = trajectory;
//   traj::FlightSet flights(traj::TogetherRule{.parked = traj::Parked::gone});
//   flights.add(record, &scene, "flights.jsonl", 1);
//   const traj::ComparedFlights compared = traj::compare_flights(flights);
//   assert(compared.found.refused == 0 && compared.records.starts_with("{\"type\":\"together\""));

#include <string>

#include "geom/base/execution.h"
#include "traj/check/flight_set.h"
#include "traj/submit/submission.h"

namespace traj {

struct ComparedFlights {
  std::string records;       // pairs.jsonl: the pairs that come too near, and all of them in one
  std::string certificates;  // pair_certificates.jsonl: why all keep apart; empty where some do not
  FlightPairs found;
};

// In exact numbers, by the rule of the set. The same for any number of threads.
ComparedFlights compare_flights(FlightSet& flights, const geom::Execution& run = {});

}  // namespace traj
