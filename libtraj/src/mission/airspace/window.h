#pragma once

// A flight during a window of time, as the control points of its stretches.

#include <vector>

#include "together/timeline.h"
#include "traj/together/timed_flight.h"

namespace traj {

// The stretches of the flight between two times, in metres from a point of it, each with a bound on
// how far each coordinate is off, steps between segments included.
struct Window {
  struct Stretch {
    RelativeCurve curve;
    double off = 0;
  };
  Vec3 from = Vec3::Zero();
  std::vector<Stretch> stretches;  // none: it does not fly then
};

// Closed, `begin` < `end` (seconds after the epoch), and at most a nanosecond longer at either end.
Window window_of(const Timeline& line, double begin, double end);

}  // namespace traj
