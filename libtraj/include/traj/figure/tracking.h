#pragma once

// A figure of how well a flight followed what was asked of it.
//
// Example:
//   traj::FlightLog log{.id = "f1"};
//   for (const double time : {0.0, 1.0, 2.0}) log.samples.push_back({.time = time});
//   const std::string svg = traj::figure::tracking(log);
//   assert(svg.find("tracking error") != std::string::npos);

#include <string>
#include <string_view>

#include "traj/curve/trajectory.h"
#include "traj/flight/flight_log.h"
#include "traj/record/tube_record.h"

namespace traj::figure {

// An SVG of the distance between vehicle and setpoint over time with its root mean square and
// largest value, of position beside setpoint on each axis, of speed, of tilt, and of the motors.
// What the log does not say is left out. `plan`, where there is one, in ENU: drawn beside the
// position, from the log's time 0 on. `tube`, where there is one, is of the plan: its radius is
// drawn beside the distance, with what stands behind it. `note` stands after the title.
std::string tracking(const FlightLog& flight, std::string_view note = "",
                     const Trajectory* plan = nullptr, const TubeRecord* tube = nullptr);

}  // namespace traj::figure
