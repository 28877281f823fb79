#pragma once

// A flight whose departure is to be chosen.
//
// Example:
//   traj::FleetFlight flight{.trajectory = &trajectory, .room = scene.half()};
//   flight.earliest = 60;  // seconds after the epoch
//   flight.latest = 300;

#include <cstdint>
#include <vector>

#include "traj/curve/trajectory.h"
#include "traj/fleet/departure_span.h"
#include "traj/together/timed_flight.h"

namespace traj {

struct FleetFlight {
  const Trajectory* trajectory = nullptr;  // within domain.h; must outlive this
  Vec3 room = Vec3::Zero();                // half sizes with the margin, metres, >= 0
  double earliest = 0;                     // seconds after the epoch: when it wants to depart
  double latest = 0;                       // >= earliest
  int priority = 0;                        // higher goes first
  std::uint32_t number = 0;                // several of one number are one flight by different ways
  // Seconds after the epoch at which it must not depart, whatever others do: forbidden_by_map(),
  // forbidden_by_moving().
  std::vector<DepartureSpan> forbidden = {};
  // Its departure is not to be chosen, as another operator's: it departs at `earliest`, whatever
  // others do. Then latest = earliest, nothing is forbidden, and it is alone of its number.
  bool settled = false;
};

}  // namespace traj
