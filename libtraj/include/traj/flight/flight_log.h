#pragma once

// Flight logs as CSV: the motion of a vehicle beside its setpoints.
//
// Example:
//   traj::FlightLog log{.id = "q1"};
//   for (const double t : {0.0, 0.5}) {
//     log.samples.push_back(traj::nothing_known());
//     log.samples.back().time = t;
//   }
//   std::stringstream file;
//   traj::write_flight_log(file, {{log}});
//   assert(traj::read_flight_log(file, "q1.csv")[0].samples.size() == 2);
//
// Always in ENU axes, whatever the map's; body axes are x forward, y left, z up.

#include <Eigen/Geometry>
#include <array>
#include <iosfwd>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geom/base/vec3.h"

namespace traj {

// A quantity that a log does not have is NaN, in all components of a vector. Only time and position
// are always there. A simulated flight has everything but the battery.
struct FlightSample {
  double time = 0;                                               // s from the flight's start
  geom::Vec3 position = geom::Vec3::Zero();                      // m
  geom::Vec3 velocity = geom::Vec3::Zero();                      // m/s
  Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();  // turns body axes into ENU
  geom::Vec3 body_rates = geom::Vec3::Zero();                    // rad/s about the body's axes
  geom::Vec3 setpoint_position = geom::Vec3::Zero();             // m
  geom::Vec3 setpoint_velocity = geom::Vec3::Zero();             // m/s
  double setpoint_yaw = 0;                                       // rad from east
  std::array<double, 4> motors{};  // shares of the largest thrust, 0 to 1
  bool saturated = false;          // whether a command was clipped since the row before
  double battery = std::numeric_limits<double>::quiet_NaN();  // share that is left, 0 to 1
};

// A sample with only its time and position, which are 0.
FlightSample nothing_known();

bool is_known(const geom::Vec3& v);  // no component is NaN

struct FlightLog {
  std::string id;
  std::string map;  // geom::BoxMap::hash() of the map that it was flown on; empty: not known
  std::vector<FlightSample> samples;  // times grow
  bool cut = false;  // the vehicle may have flown before the first row or after the last
};

// The header, then the flights one after the other: parts of one file. The map stands in the first
// row of a flight. Without battery and `cut`.
void write_flight_log_header(std::ostream& out);
void write_flight(std::ostream& out, const FlightLog& log);

// A whole file. Comes back bit for bit. Has the columns `battery_share` and `end` where a flight
// has a battery or was cut. Throws InputError where an id has a line break in it, or white space or
// a byte order mark at an end.
void write_flight_log(std::ostream& out, std::span<const FlightLog> logs);

// Throws geom::InputError(name, line, …) where the text is not such a table: another header, a map
// in a row that is not the first of its flight, a row after one that ends its flight, a number that
// is not finite or out of its range, time or position missing, a vector of which only a part is
// there, a quaternion whose length is not 1 to 1e-6, times that do not grow, rows of a flight that
// do not stand together, or no row at all.
std::vector<FlightLog> read_flight_log(std::istream& in, std::string_view name);

}  // namespace traj
