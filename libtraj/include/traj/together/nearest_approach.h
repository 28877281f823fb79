#pragma once

// How near flights come to each other, for pictures and tables.
//
// Example:
//   const std::vector<traj::TimedFlight> flights = {{.trajectory = &trajectory},
//                                                   {.trajectory = &trajectory, .start = 1}};
//   for (const traj::Approach& near : traj::nearest_approaches(flights, 50.0)) {
//     std::cout << near.distance << " m apart at " << near.time << " s\n";
//   }
//
// Never for a verdict.

#include <span>
#include <vector>

#include "geom/base/execution.h"
#include "traj/together/near_pairs.h"
#include "traj/together/timed_flight.h"

namespace traj {

// The nearest approach of the reference points of two flights while both fly.
struct Approach {
  FlightPair flights;
  double distance = 0;        // metres, to 1 mm
  double time = 0;            // seconds after the epoch
  Vec3 place = Vec3::Zero();  // of the first flight then
  Vec3 other = Vec3::Zero();  // and of the other
};

// The nearest approach of every pair that comes within `within` metres (> 0), the nearest first, of
// one distance in order of the flights. By branch and bound over control points, never by samples.
// The same for any number of threads.
std::vector<Approach> nearest_approaches(std::span<const TimedFlight> flights, double within,
                                         const geom::Execution& run = {});

// The same for the smallest of the distances 1, 2, 5, 10, … metres, at most `most`, within which
// about `wanted` pairs come. The result says which distance that was.
struct Approaches {
  double within = 0;
  std::vector<Approach> list;
};
Approaches nearest_approaches(std::span<const TimedFlight> flights, std::size_t wanted, double most,
                              const geom::Execution& run = {});

}  // namespace traj
