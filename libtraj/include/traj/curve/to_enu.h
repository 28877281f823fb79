#pragma once

// From a map's axes to east-north-up, and back.
//
// Example:
//   const traj::Trajectory enu = traj::to_enu(geom::Axes::neu, trajectory);  // swaps x and y
//   assert(traj::evaluate(enu, 0).position == geom::Vec3(1, 1, 1));
//
// In east-north-up vehicles fly, drone files are written and read, and pictures are drawn.

#include "geom/map/frame.h"
#include "geom/shape/polyline.h"
#include "traj/curve/trajectory.h"

namespace traj {

// Each is its own inverse; of yaw to an ulp of pi/2, else exact.
State to_enu(geom::Axes axes, const State& state);
Trajectory to_enu(geom::Axes axes, Trajectory trajectory);
geom::Polyline to_enu(geom::Axes axes, geom::Polyline path);

}  // namespace traj
