#pragma once

// Where an autopilot may be while it flies a mission.

#include <optional>
#include <span>

#include "mission/firmware/turn.h"
#include "traj/curve/vertical_ends.h"
#include "traj/mission/firmware/autopilot.h"
#include "traj/mission/flown/sweep.h"

namespace traj {

// A mission's way. Of each point: seconds that it waits there, the part that leads to it, how it
// turns there, and the speed that was said for the leg to it.
struct DriftTask {
  std::span<const Vec3> path;
  std::span<const double> hold;
  std::span<const FlightPart> legs;
  std::span<const Turn> turns;
  std::span<const std::optional<double>> speeds;
  std::span<const Sweep> sweeps;  // circles, splines, ways from where it waits
  FlightPart landing;
  VerticalEnds ends;
  std::span<const Vec3> rally;  // places in the air to which a return may go instead
  double return_height = 0;     // m above home, where it returns
};

// From the ground to the ground: the legs; beyond each stop, as far as it is overshot, and from
// there to the next leg; corners, before and behind; where a take-off is left and a landing begins.
Drift drift_of(const Autopilot& autopilot, const DriftTask& task);

}  // namespace traj
