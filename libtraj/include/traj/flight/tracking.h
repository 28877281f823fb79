#pragma once

// How well a flight followed its trajectory.
//
// Example:
//   traj::Flight flight;
//   flight.error.assign(200, 0.02);  // 2 cm off all the time
//   const traj::Tracking tracking = traj::tracking(flight, 1);
//   assert(std::abs(tracking.rms - 0.02) < 1e-12);

#include <optional>

#include "traj/flight/simulate.h"

namespace traj {

inline constexpr double kSettled = 0.05;  // m

// Figures of the distances to the reference at the same instant, every 10 ms.
struct Tracking {
  double mean = 0;  // m, these four up to the trajectory's end
  double rms = 0;
  double p99 = 0;  // by nearest rank
  double largest = 0;
  double largest_time = 0;         // s
  double arrival = 0;              // m, at the trajectory's end
  double final_distance = 0;       // m, once it has hovered there
  std::optional<double> settling;  // s after the trajectory's end until it stays within kSettled
};

// The figures of a flight that was not lost, along a trajectory of this duration.
Tracking tracking(const Flight& flight, double duration);

}  // namespace traj
