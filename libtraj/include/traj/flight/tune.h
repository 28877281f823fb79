#pragma once

// Gains found by trying: the velocity loop first, then the position loop around it.

#include "geom/base/execution.h"
#include "traj/flight/tracking.h"

namespace traj {

// What the position loop's search makes small, a weighted sum.
struct FlightCost {
  double mean = 0;
  double rms = 1;
  double p99 = 0;
  double largest = 0;
  double final_distance = 0;
  double saturated = 0;  // m per share
};

struct TuneResult {
  Gains gains;
  double velocity_cost = 0;  // m/s: root mean square of the velocity error, position loop open
  double cost = 0;           // FlightCost with all loops closed
  std::size_t flights = 0;
};

// A compass search on the logarithms of the gains, x and y alike: all neighbours of a point are
// flown, the best (ties: the first) is the next point, and the step is halved when none is better.
// Costs are means over the tracks; a lost flight is worse than any other. The same for any number
// of threads.
TuneResult tune(std::span<const ReferenceTrack> tracks, const FlightOptions& base,
                const FlightCost& cost, const geom::Execution& run);

}  // namespace traj
