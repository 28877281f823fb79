#pragma once

// How far a flight was from its plan, and how much of it stayed within the tracking tube.
//
// Example:
//   const std::vector<geom::Vec3> points = {traj::evaluate(trajectory, 1).position};
//   const std::vector<double> times = {1.2};  // late, but on its way
//   const traj::FlownTube tube = traj::flown_tube(trajectory, {{0.1}}, 100, points, times);
//   assert(tube.inside == 1 && tube.furthest.value < 1e-3);

#include <cstddef>
#include <span>

#include "traj/curve/trajectory.h"
#include "traj/proof/check.h"

namespace traj {

// Distances are in space: a vehicle that flies the plan earlier, later or more slowly is as far
// from it as from the nearest place of the plan, because the tube was held against the map without
// times.
struct FlownTube {
  Extreme furthest;        // m from the plan, of all samples, to 0.1 mm or better; when that was
  std::size_t inside = 0;  // samples surely within the tube
  double left = 0;         // s: the first sample that is not, where there is one
};

// `points` in the axes of the plan, at `times`; at least one. radius[k] is that of [k, k + 1] *
// period of the plan, the last holding beyond (TrackingTube, check_tube); none: nothing is inside.
// Only samples are judged, not what lies between them.
FlownTube flown_tube(const Trajectory& plan, std::span<const double> radius, double period,
                     std::span<const Vec3> points, std::span<const double> times);

}  // namespace traj
