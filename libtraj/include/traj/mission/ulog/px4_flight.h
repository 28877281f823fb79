#pragma once

// The flight that a PX4 log (ULog) holds, as a flight log.
//
// Example:
//   std::ifstream in("hop.ulg", std::ios::binary);
//   const traj::Px4Flight flight = traj::read_px4_flight(in, "hop.ulg", {});
//   std::cout << flight.log.samples.size() << " positions from " << flight.topic << '\n';

#include <iosfwd>
#include <optional>
#include <string_view>

#include "geom/map/geographic_frame.h"
#include "traj/curve/mission_frame.h"
#include "traj/flight/flight_log.h"
#include "traj/mission/ulog/ulog_reader.h"

namespace traj {

struct Px4Options {
  // Where the log's coordinates shall count from. Nothing: from the log's own reference, or, of a
  // vehicle that did not know where on Earth it was, from where its local coordinates do.
  std::optional<MissionFrame> over;
};

struct Px4Flight {
  FlightLog log;        // without id and map; no samples where no position is known
  UlogSummary summary;  // of the file
  std::string topic;    // that the positions are from

  std::size_t positions = 0;  // that the topic has
  std::size_t not_known = 0;  // of these, left out: the vehicle did not know where it was
  std::size_t nowhere = 0;    // left out: it did not know where on Earth that is, and `over` asks
  std::size_t back = 0;       // left out: the time did not grow, or its clock was set back by 1 s
  // Each of the next five, and corrected_in_air, says that the log is cut, if it is not 0 or false;
  // the first one only where the vehicle may have flown then.
  std::size_t left_out_at_begin = 0;  // of all these, the ones before the first sample
  bool begins_in_air = false;         // it flew, or may have flown, before the first sample
  std::size_t left_out_at_end = 0;    // the ones after the last sample
  bool ends_silent = false;           // other topics go on for more than 1 s after the last sample
  bool ends_in_air = false;           // it has not come to the ground when the log ends
  bool tells_landed = false;          // the log says when the vehicle stands on the ground

  std::optional<geom::GeodeticPlace> reference;  // the first, height above the sea
  std::optional<double> sea_level;               // m above the ellipsoid, as the log has it
  std::size_t resets = 0;           // of the position: steps of the estimate, not of the vehicle
  double largest_reset = 0;         // m
  double largest_reset_in_air = 0;  // m
  bool corrected_in_air = false;    // by more than 1 m: nobody knows where it was before
  std::optional<double> takeoff;    // s in the log
  std::optional<double> deviation;  // m: the largest horizontal one that the vehicle claims
  std::optional<double> vertical_deviation;
};

// Positions are those of vehicle_local_position that the vehicle held for valid, each placed by its
// own reference, else those of vehicle_global_position. The time counts from the first of them. All
// else is the last that was logged before, at most 1 s old: velocity, attitude
// (vehicle_attitude), body rates (vehicle_angular_velocity, or the attitude's), setpoints
// (trajectory_setpoint, else vehicle_local_position_setpoint), battery (battery_status), motors
// (actuator_motors, where there are four). What is not known is NaN (flight_log.h). Axes become
// those of a flight log, turned by the angle between the projections' norths. Throws
// geom::InputError as read_ulog does.
Px4Flight read_px4_flight(std::istream& in, std::string_view source, const Px4Options& options);

// Raises or lowers the flight so that the lowest position of the 10 s before the take-off is at
// z = `ground`, metres, and returns the z that it had. Throws geom::InputError(source, …) where the
// log has no take-off after a position. Before begin_at().
double take_off_from(double ground, Px4Flight& flight, std::string_view source);

// Leaves out all before `begin` seconds, and counts from there. Returns whether the vehicle may
// have been in the air in what is left out; then the log is cut.
bool begin_at(double begin, Px4Flight& flight);

}  // namespace traj
