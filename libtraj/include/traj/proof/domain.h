#pragma once

// The domain of both checks: the numbers that they can judge.
//
// Example:
//   assert(!traj::outside_domain(trajectory, limits));
//   const auto outside = traj::outside_domain(traj::Limits{{traj::Limit::speed, 1e12}});
//   assert(outside->reason == traj::Reason::limits);
//
// Within it neither the check nor the exact check overflows, divides by nearly 0, or compares NaN.
// Both refuse all other numbers alike.

#include <optional>
#include <span>

#include "traj/curve/trajectory.h"
#include "traj/proof/limits.h"
#include "traj/proof/reason.h"

namespace traj {

inline constexpr double kShortestSegment = 1e-9;   // seconds
inline constexpr double kLongestTrajectory = 1e9;  // seconds, of all segments together
inline constexpr double kLeastLimit = 1e-9;        // of any limit, in its unit
inline constexpr double kLargestLimit = 1e9;

// Why something cannot be judged.
struct OutsideDomain {
  Reason reason = Reason::none;  // duration, coordinates or limits
  double value = 0;              // what stood there
  double time = 0;               // of the segment, seconds; of a path the index of the point
};

// Nothing when each duration is within kShortestSegment and kLongestTrajectory, and their sum; each
// control point and yaw within geom::kLargestCoordinate; each limit within kLeastLimit and
// kLargestLimit, the tilt below pi/2, the thrust above kGravity. Reason::duration also when there
// is no segment. NaN is never within.
std::optional<OutsideDomain> outside_domain(const Trajectory& trajectory, const Limits& limits);

// The same for limits alone.
std::optional<OutsideDomain> outside_domain(const Limits& limits);

// The same for the points of a path.
std::optional<OutsideDomain> outside_domain(std::span<const Vec3> points);

// The first segment without yaw, where others have one: a limit on the yaw rate cannot be judged
// there.
std::optional<std::size_t> gap_in_yaw(const Trajectory& trajectory);

}  // namespace traj
