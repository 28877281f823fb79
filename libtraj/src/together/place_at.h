#pragma once

#include <algorithm>

#include "traj/together/timed_flight.h"

namespace traj {

// Where a flight is at a time; before and after at its first and its last point. Rounded, for
// reports.
inline Vec3 place_at(const TimedFlight& flight, double time) {
  const double t = std::clamp(time - flight.start, 0.0, duration(*flight.trajectory));
  return evaluate(*flight.trajectory, t).position;
}

}  // namespace traj
