#pragma once

// Closed intervals of seconds, and sets of them.
//
// Example:
//   const auto spans = traj::united({{0, 10}, {8, 12}, {20, 30}});
//   assert(spans.size() == 2 && spans[0].holds(11));

#include <limits>
#include <vector>

namespace traj {

// low <= high; either may be infinite. Of departures, or of differences between two departures.
struct DepartureSpan {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();

  bool holds(double t) const { return low <= t && t <= high; }

  friend bool operator==(const DepartureSpan&, const DepartureSpan&) = default;
};

// The same set as intervals that do not touch, in order.
std::vector<DepartureSpan> united(std::vector<DepartureSpan> spans);

}  // namespace traj
