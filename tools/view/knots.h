#pragma once

// A trajectory in few numbers: its state at each joint, from which the page works out the very
// polynomial between two joints, whatever the time that is looked at.

#include <vector>

#include "bundle.h"
#include "local_frame.h"
#include "traj/curve/trajectory.h"

namespace view {

// The state at an instant, and how long after the one before it that is: 0 where the segments do
// not meet, so that there are two states of one instant.
struct Knot {
  double step = 0;  // seconds; of the first 0
  traj::State state;
};

// At every joint; where there would be more than `most` (>= 2), at as many instants evenly spread,
// between which the page is near the polynomials, no longer on them.
std::vector<Knot> knots_of(const traj::Trajectory& trajectory, std::size_t most);

// {"knots":count,"step":…,"position":…,"velocity":…,"acceleration":…,"jerk":…} into `out`.
void add_knots(Json& out, const std::vector<Knot>& knots, const LocalFrame& frame, Bundle& bundle);

}  // namespace view
