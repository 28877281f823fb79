#pragma once

// A flight over all time, and what two flights are to each other between their joints.

#include <optional>
#include <vector>

#include "curve/curve_piece.h"
#include "ticks.h"
#include "traj/together/timed_flight.h"

namespace traj {

// A flight with its joints: segment i from joint[i] to joint[i + 1].
struct Timeline {
  explicit Timeline(const TimedFlight& flight);

  const std::vector<Segment>* segments;
  std::vector<Ticks> joint;
  double gap = 0;  // metres: the most that segments miss each other by along an axis, rounded up
};

// A time in which each of two flights is on one segment, or parked. Without a begin or an end both
// are parked for ever on that side.
struct CommonStretch {
  std::optional<Ticks> begin = {};
  std::optional<Ticks> end = {};
  std::optional<std::size_t> segment = {};  // of the first flight; none: parked
  std::optional<std::size_t> other = {};
  bool first_over = false;  // parked where it ends, not where it begins
  bool other_over = false;
};

// All time in which both are there, in order; the ends of neighbours are the same instant. An
// instant alone is a stretch where that is all they share.
std::vector<CommonStretch> stretches(const Timeline& a, const Timeline& b, Parked parked);

// The way of the first flight as the other sees it: its position less the other's, as the control
// points of one polynomial over the stretch. `scale` bounds every coordinate that went into it,
// from a place near both: each coordinate of a point is within 2^-53 times 340 times `scale`.
struct RelativeCurve {
  Points<kPoints> q{};
  double scale = 0;
};
RelativeCurve relative_curve(const Timeline& a, const Timeline& b, const CommonStretch& stretch);

// How far each coordinate of a point may be off after so many halvings of the whole stretch.
inline double rounding_after(const RelativeCurve& whole, int halvings) {
  return (340 + 16 * halvings) * 0x1p-53 * whole.scale + 1e-300;
}

}  // namespace traj
