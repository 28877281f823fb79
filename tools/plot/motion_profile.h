#pragma once

// Height, speed, acceleration and jerk over time.

#include <string>

#include "traj/io/trajectory_record.h"

namespace plot {

// An SVG of four panels, with the record's limits as dashed lines. The trajectory is not empty.
std::string motion_profile(const traj::TrajectoryRecord& record);

}  // namespace plot
