#pragma once

// The proof that two flights keep apart at every instant.
//
// Example:
//   const traj::TimedFlight first{.trajectory = &trajectory};
//   const traj::TimedFlight second{.trajectory = &trajectory, .start = 100};
//   const std::vector zones = {traj::cylinder(0.5, 0.5)};
//   assert(traj::check_pair(first, second, zones, traj::Parked::gone).apart);
//   assert(!traj::check_pair(first, first, zones, traj::Parked::gone).apart);

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "traj/together/spacing.h"
#include "traj/together/timed_flight.h"

namespace traj {

// Seconds after the epoch; infinite where there is no begin or end.
struct TimeSpan {
  double begin = -std::numeric_limits<double>::infinity();
  double end = std::numeric_limits<double>::infinity();
};

struct PairResult {
  bool apart = false;
  // Not apart, and no instant of conflict is known either: they are within rounding of it, or the
  // halvings came to an end.
  bool undecided = false;
  std::size_t pieces = 0;  // that were looked at

  // When they are not apart. At all other times they are proved to be.
  std::vector<TimeSpan> when;  // in order, to 1 ms
  double time = 0;             // of the nearest approach, in the norm of the zone
  std::size_t zone = 0;        // which
  double share = 0;            // how near in that norm: a conflict at 1 or below
  double depth = 0;            // metres in the zone
  Vec3 place = Vec3::Zero();   // of the first flight then
  Vec3 other = Vec3::Zero();   // and of the other
};

// Decides by the control points of the first flight's position less the other's, on each stretch of
// time between their joints: all of them beyond one plane (a side of the zone, or upright and
// touching a cylinder) is apart, else the stretch is halved. Joints are compared exactly
// (ticks.h), and a difference is taken relative to a place near both, so what is refused comes
// within 1e-13 of the flights' size of a zone, at most (timeline.h). "apart" holds in real
// arithmetic; a limit on halvings ends as undecided. Joints that miss each other count as the
// straight step between. Symmetric in the two but for signs. Throws InputError for a flight outside
// of domain.h, and for times, rooms and zones that are not numbers or are below 0. Without zones
// all are apart.
PairResult check_pair(const TimedFlight& a, const TimedFlight& b, std::span<const Zone> zones,
                      Parked parked);

}  // namespace traj
