#pragma once

// A figure of what a trajectory asks of a vehicle over time.
//
// Example:
//   traj::TrajectoryRecord record{.id = "q1", .status = traj::TrajectoryStatus::solved};
//   record.trajectory = trajectory;
//   const std::string svg = traj::figure::motion_profile(record);
//   assert(svg.find("speed, m/s") != std::string::npos);

#include <string>
#include <string_view>

#include "traj/record/trajectory_record.h"

namespace traj::figure {

// An SVG of position in east, north, up, speed, acceleration, jerk and snap with the integrals of
// their squares, thrust over mass and tilt (by differential flatness), the limits of the record
// beside them. The record is solved. `note` stands after the title.
std::string motion_profile(const TrajectoryRecord& record, std::string_view note = "");

}  // namespace traj::figure
