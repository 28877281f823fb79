#pragma once

// The proof that all flights of a set keep apart, each from each, at every instant.
//
// Example:
//   const traj::TimedFlight first{.trajectory = &trajectory, .room = scene.half()};
//   traj::TimedFlight second = first;
//   second.start = traj::duration(trajectory) + 10;  // once the first has gone
//   const std::vector flights = {first, second};
//   assert(traj::check_together(flights, {.parked = traj::Parked::gone}).ok());
//   assert(!traj::check_together(flights, {.parked = traj::Parked::pad}).ok());  // it stands there

#include <cstddef>
#include <span>
#include <vector>

#include "geom/base/execution.h"
#include "traj/together/exact/exact_pair.h"
#include "traj/together/near_pairs.h"
#include "traj/together/pair_check.h"

namespace traj {

struct TogetherRule {
  Spacing spacing;
  Parked parked = Parked::pad;
  bool exact = false;  // check near pairs once more in exact numbers; both must accept
};

struct RefusedPair {
  FlightPair flights;
  std::vector<Zone> zones;
  PairResult result;  // apart where the exact check alone refuses
};

struct ProvedPair {
  FlightPair flights;
  ExactPair proof;
};

struct TogetherResult {
  std::size_t pairs = 0;             // of all flights
  std::size_t near = 0;              // that boxes alone did not keep apart
  std::size_t pieces = 0;            // of relative curves that were looked at for these
  std::vector<RefusedPair> refused;  // in order
  std::vector<ProvedPair> proved;    // near pairs that are accepted, where the rule is exact

  bool ok() const { return refused.empty(); }
};

// near_pairs(), and check_pair() of those. The same for any number of threads.
TogetherResult check_together(std::span<const TimedFlight> flights, const TogetherRule& rule,
                              const geom::Execution& run = {});

}  // namespace traj
