#pragma once

// What the check of flights against one another found, as JSON Lines records.
//
// Example:
//   const traj::TimedFlight first{.trajectory = &trajectory, .room = scene.half()};
//   const traj::TimedFlight second{.trajectory = &trajectory, .start = 1, .room = scene.half()};
//   const std::vector flights = {first, second};
//   const traj::TogetherTask task{.ids = {"a", "b"}};
//   const traj::TogetherResult result = traj::check_together(flights, task.rule);
//   for (const traj::RefusedPair& pair : result.refused) std::cout << traj::in_words(pair, task);
//   std::cout << traj::to_json_line(result, task, 0);

#include <span>
#include <string>
#include <vector>

#include "geom/record/record.h"
#include "traj/together/check_together.h"

namespace traj {

// The question to the check.
struct TogetherTask {
  std::vector<std::string> ids;  // of the flights
  TogetherRule rule;
  std::optional<std::string> epoch;
  std::optional<std::string> map;    // its hash
  std::string flights_hash;          // see flights_hash.h
  std::vector<std::string> dropped;  // ids of flights that were refused alone, and are no part
  bool overridden = false;           // a vehicle or margin is smaller than its record says
};

// The record of a pair that is refused; ends with a newline.
std::string to_json_line(const RefusedPair& pair, const TogetherTask& task);

// The record of all pairs; ends with a newline. `left_out`: flights that could not be looked at;
// any refuses the whole.
std::string to_json_line(const TogetherResult& result, const TogetherTask& task,
                         std::size_t left_out);

// Why a near pair is apart, and what all pairs claim; each ends with a newline.
// docs/certificates.md has the conditions for them. `flights` are those of the ids.
std::string certificate_line(const ProvedPair& pair, const TogetherTask& task);
std::string certificate_line(const TogetherTask& task, std::span<const TimedFlight> flights);

// The refusal in a sentence.
std::string in_words(const RefusedPair& pair, const TogetherTask& task);

}  // namespace traj
