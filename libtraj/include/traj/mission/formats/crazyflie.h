#pragma once

// Crazyflie polynomial trajectories: the CSV that crazyswarm and uav_trajectories use.
//
// Example:
//   std::stringstream file;
//   traj::write_crazyflie(file, trajectory);  // in ENU
//   const traj::CrazyflieFlight flight = traj::read_crazyflie(file, "flight.csv");
//   assert(flight.stray.size() == trajectory.segments.size());  // what single precision adds

#include <iosfwd>
#include <string_view>
#include <vector>

#include "traj/curve/trajectory.h"
#include "traj/proof/check.h"

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

// What the drone's firmware makes of such a table, told after its public sources
// (crazyflie-firmware, src/modules/src/pptraj.c and crtp_commander_high_level.c, as they stood in
// 2023; 2026.08 computes the same):
// - It keeps 33 floats a segment: the numbers of the table rounded to single precision.
// - Its clock is microseconds since it was switched on, as seconds in single precision. The time t
//   in a segment is that less the time of the start and less each duration before it, rounded
//   after each subtraction. So t is a float in [0, duration]: rounding moves the setpoint along
//   the curve, by up to 1 + n / 2 steps of the clock in the n-th segment, never off it, and the
//   durations of segments that were passed do not add up to an error of place.
// - Position is Horner's rule in single precision, from the highest power; velocity, acceleration
//   and jerk the same on coefficients that were multiplied by their power first. A compiler may
//   join each product and sum to one rounding, and small numbers may be flushed to zero.
// So the setpoint differs from the polynomial of the rounded coefficients by no more than the error
// of Horner's rule, bounded step by step (Higham, Accuracy and Stability of Numerical Algorithms,
// 2nd ed., algorithm 5.1, with ranges of the partial sums over 64 parts of the segment in place of
// their values): `stray`. It is meant for a start that is neither relative, reversed nor stretched.
struct CrazyflieFlight {
  Trajectory trajectory;     // of the coefficients rounded to single precision, in ENU
  std::vector<Stray> stray;  // of each segment: what single precision may add
};

// The longest flight that is read: from there on the clock's step is 1/128 s and more, no longer
// small beside the 10 ms between setpoints. A battery lasts 420 s.
inline constexpr double kCrazyflieLongest = 65536;  // s

// A first line that begins with a letter is the header, whose names must be those columns, as many
// as it has (and "UNCHECKED…"); lines may end with a comma. Throws geom::InputError(source, line,
// …) where the text is not such a table, for a flight of over 65536 s or beyond 1e8 m, numbers
// beyond single precision, and a last line without its end, which may have lost digits.
CrazyflieFlight read_crazyflie(std::istream& in, std::string_view source);

}  // namespace traj
