#pragma once

// Crazyflie polynomial trajectories: the CSV that crazyswarm and uav_trajectories use.

#include <iosfwd>
#include <string_view>

#include "traj/trajectory.h"

namespace traj {

inline constexpr std::size_t kCrazyflieSegments = 31;  // what its memory holds

// How much of the drone's 4096 bytes for trajectories one takes: 132 a segment as polynomials, or,
// in its compressed form of millimetres in 16 bits, 8 and for each segment 3 and 14 for each of x,
// y, z and yaw that is not constant. Compressed, coordinates must be within 32.767 m of the origin,
// yaw within 3276.7 degrees, durations at most 65.535 s.
struct CrazyflieMemory {
  std::size_t bytes = 0;
  std::size_t compressed_bytes = 0;
  bool fits = false;
  bool compressed_fits = false;
};
CrazyflieMemory crazyflie_memory(const Trajectory& enu);

// A header and 33 columns: duration, x^0..x^7, y^0..y^7, z^0..z^7, yaw^0..yaw^7; ascending powers,
// seconds, metres (ENU), radians. Numbers by shortest round trip.
void write_crazyflie(std::ostream& out, const Trajectory& enu);

// The trajectory as the drone flies it, in ENU: every number rounded to single precision. A first
// line that begins with a letter is the header; lines may end with a comma. Throws
// geom::InputError(source, line, …) where the text is not such a table.
Trajectory read_crazyflie(std::istream& in, std::string_view source);

}  // namespace traj
