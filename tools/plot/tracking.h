#pragma once

// How well a flight followed what was asked of it.

#include <string>
#include <string_view>

#include "traj/record/flight_log.h"

namespace plot {

// An SVG of the distance between vehicle and setpoint over time with its root mean square and
// largest value, of position beside setpoint on each axis, of speed, of tilt, and of the motors.
// `note` stands after the title.
std::string tracking(const traj::FlightLog& flight, std::string_view note = "");

}  // namespace plot
