#pragma once

// A tree over boxes in space and time, and the pairs of its boxes that meet.

#include <array>
#include <cstdint>
#include <vector>

#include "geom/base/execution.h"
#include "traj/together/near_pairs.h"

namespace traj {

// A closed box: x, y, z in metres and a time in seconds, which may be infinite. Of a flight.
struct TimedBox {
  std::array<double, 4> low{};
  std::array<double, 4> high{};
  std::uint32_t flight = 0;
};

bool meet(const TimedBox& a, const TimedBox& b);

// The pairs of flights of which two boxes meet, in order, each once. Boxes that last for ever and
// others are kept apart in the tree. The same for any number of threads.
std::vector<FlightPair> meeting_flights(std::vector<TimedBox> boxes, const geom::Execution& run);

}  // namespace traj
