#pragma once

// Identifies the flights of a check of all against one another.
//
// Example:
//   const std::vector<traj::TimedFlight> flights = {{.trajectory = &trajectory}};
//   const std::vector<std::string> ids = {"q1"};
//   assert(traj::flights_hash(ids, flights, std::nullopt).size() == 64);

#include <optional>
#include <span>
#include <string>

#include "traj/together/timed_flight.h"

namespace traj {

// SHA-256, in hexadecimal, over the epoch (empty where there is none), a line feed, and the flights
// sorted by id: of each the id, a line feed, its start, the number of its segments, and of each
// segment the duration and the control points, all as little-endian float64. It does not depend
// on the order of the stream. `ids` are those of `flights`.
std::string flights_hash(std::span<const std::string> ids, std::span<const TimedFlight> flights,
                         const std::optional<std::string>& epoch);

}  // namespace traj
