#pragma once

// From a map's axes to east-north-up, in which every drone file is written and read, and back.

#include "geom/frame.h"
#include "geom/polyline.h"
#include "traj/trajectory.h"

namespace traj {

// Each is its own inverse; of yaw to an ulp of pi/2, else exact.
Trajectory in_enu(geom::Axes axes, Trajectory trajectory);
geom::Polyline in_enu(geom::Axes axes, geom::Polyline path);

}  // namespace traj
