#pragma once

// What a trajectory asks of a vehicle over time.

#include <string>
#include <string_view>

#include "traj/record/trajectory_record.h"

namespace plot {

// An SVG of position in east, north, up, speed, acceleration, jerk and snap with the integrals of
// their squares, thrust over mass and tilt (by differential flatness), the limits of the record
// beside them. The record is solved. `note` stands after the title.
std::string motion_profile(const traj::TrajectoryRecord& record, std::string_view note = "");

}  // namespace plot
