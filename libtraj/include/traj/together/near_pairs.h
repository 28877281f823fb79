#pragma once

// Which of many flights may come near each other: by boxes in space and time.
//
// Example:
//   const traj::TimedFlight first{.trajectory = &trajectory, .room = scene.half()};
//   const traj::TimedFlight second{.trajectory = &trajectory, .start = 1e6, .room = scene.half()};
//   const std::vector flights = {first, second};
//   assert(traj::near_pairs(flights, {}, traj::Parked::gone).empty());  // days apart

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "geom/base/execution.h"
#include "traj/together/spacing.h"
#include "traj/together/timed_flight.h"

namespace traj {

using FlightPair = std::pair<std::uint32_t, std::uint32_t>;  // indices of flights, first < second

// Segments are halved until the box around one is at most so large, metres.
inline constexpr double kNearStep = 100;

// Pairs that may come near. Every other pair is apart at every instant: no box around a piece of
// the one, with its time and grown by reach_of(), meets one of the other. Rounded outward. In
// order, each once. Throws InputError for flights and zones as check_pair() does. A tree of boxes
// in four dimensions: the cost grows with flights and pairs.
std::vector<FlightPair> near_pairs(std::span<const TimedFlight> flights, const Spacing& spacing,
                                   Parked parked, const geom::Execution& run = {},
                                   double step = kNearStep);

}  // namespace traj
