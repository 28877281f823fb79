#pragma once

// Gains found by trying: the velocity loop first, then the position loop around it.
//
// Example, not run:
//   const std::vector<traj::ReferenceTrack> tracks = {traj::ReferenceTrack(trajectory)};
//   const traj::TuneResult tuned = traj::tune(tracks, traj::FlightOptions{}, {}, {.threads = 4});
//   if (tuned.improved) std::cout << traj::to_json(tuned.gains);

#include <optional>

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
  // FlightCost with all loops closed, on the same flights: of the gains that it began with, and of
  // `gains`. Absent where a flight is lost.
  std::optional<double> before;
  std::optional<double> cost;
  bool improved = false;  // else `gains` are those that it began with, bit for bit
  std::size_t flights = 0;
};

// A compass search on the logarithms of the gains, x and y alike: all neighbours of a point are
// flown, the best (ties: the first) is the next point, and the step is halved when none is better.
// Costs are means over the tracks; a lost flight is worse than any other. The same for any number
// of threads.
//
// Gains that follow velocities best need not follow the trajectory best, least of all in noise. So
// where the two searches end no better than they began, the position loop is searched around the
// velocity loop as it was; and where that is no better either, `base.gains` are the result.
TuneResult tune(std::span<const ReferenceTrack> tracks, const FlightOptions& base,
                const FlightCost& cost, const geom::Execution& run);

}  // namespace traj
