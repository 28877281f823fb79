#pragma once

// What the check of flights against one another said, read back to be shown.
//
// Example:
//   const std::vector<traj::TimedFlight> flights = {{.trajectory = &trajectory}};
//   const traj::TogetherTask task{.ids = {"a"}, .flights_hash = "0"};
//   const std::string line = traj::to_json_line(traj::check_together(flights, task.rule), task, 0);
//   assert(traj::parse_together_record(line, "together.jsonl", 1).ok);

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "traj/together/spacing.h"

namespace traj {

// A pair that was refused.
struct PairSummary {
  std::string first;  // ids of the two flights
  std::string second;
  std::string reason;  // "separation" or "undecided"
  double time = 0;     // of the nearest approach, seconds after the epoch
  double share = 0;    // how near then, in the norm of the zone: a conflict at 1 or below
  double across = 0;   // metres apart then, over the ground and in height
  double up = 0;
  std::optional<Zone> zone;  // what was asked; nothing in records that do not say it
};

// The summary of all flights.
struct TogetherSummary {
  bool ok = false;
  std::size_t flights = 0;
  std::size_t pairs = 0;
  std::size_t refused = 0;
  std::size_t left_out = 0;  // flights that were refused, so that their pairs were not compared
  bool overridden = false;   // a vehicle or margin is smaller than its record says
  std::optional<Zone>
      separation;  // what was asked of every pair; nothing where the vehicles' sizes say it
  std::optional<std::string> map;  // its hash
  std::string flights_hash;        // see flights_hash.h
};

// Both throw InputError(source, line, …) for anything that is not such a record.
PairSummary parse_pair_record(std::string_view json, std::string_view source, std::size_t line);
TogetherSummary parse_together_record(std::string_view json, std::string_view source,
                                      std::size_t line);

}  // namespace traj
