#pragma once

// How well a flight followed what was asked of it.

#include <string>
#include <string_view>

#include "traj/curve/trajectory.h"
#include "traj/flight/flight_log.h"
#include "traj/record/tube_record.h"

namespace plot {

// An SVG of the distance between vehicle and setpoint over time with its root mean square and
// largest value, of position beside setpoint on each axis, of speed, of tilt, and of the motors.
// What the log does not say is left out. `plan`, where there is one, in ENU: drawn beside the
// position, from the log's time 0 on. `tube`, where there is one, is of the plan: its radius is
// drawn beside the distance, with what stands behind it. `note` stands after the title.
std::string tracking(const traj::FlightLog& flight, std::string_view note = "",
                     const traj::Trajectory* plan = nullptr,
                     const traj::TubeRecord* tube = nullptr);

}  // namespace plot
