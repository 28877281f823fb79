#pragma once

// Crazyflie polynomial trajectories: the CSV that crazyswarm and uav_trajectories use.

#include <iosfwd>
#include <string_view>

#include "geom/frame.h"
#include "traj/trajectory.h"

namespace traj {

inline constexpr std::size_t kCrazyflieSegments = 31;  // what its memory holds

// A header and 33 columns: duration, x^0..x^7, y^0..y^7, z^0..z^7, yaw^0..yaw^7; ascending powers,
// seconds, metres (ENU), radians. Numbers by shortest round trip.
void write_crazyflie(std::ostream& out, const Trajectory& trajectory, geom::Axes axes);

// The trajectory as the drone flies it: every number rounded to single precision, in the map's
// axes. Throws geom::InputError(source, line, …) where the text is not such a table.
Trajectory read_crazyflie(std::istream& in, std::string_view source, geom::Axes axes);

}  // namespace traj
