#pragma once

// Setpoints at a fixed rate, as CSV: what a streaming client sends to the autopilot.
//
// Example:
//   const std::vector<traj::Setpoint> wanted = traj::setpoints(trajectory, 10);  // 10 Hz
//   std::stringstream file;
//   traj::write_setpoints(file, wanted, traj::SetpointAxes::ned);
//   assert(traj::read_setpoints(file, "flight.csv").size() == wanted.size());

#include <iosfwd>
#include <string_view>
#include <vector>

#include "traj/curve/setpoint.h"

namespace traj {

enum class SetpointAxes { enu, ned };

// What a trajectory in ENU wants at k / rate seconds (rate in Hz, > 0) and at its very end, in ENU.
// Yaw is 0 where none is given.
std::vector<Setpoint> setpoints(const Trajectory& enu, double rate);

// `t_s`, then position, velocity, acceleration, yaw and yaw rate. ENU: east_m,north_m,up_m,… with
// yaw counterclockwise from east; NED: n_m,e_m,d_m,vn_m_s,… with yaw clockwise from north. A table
// that nobody checked has one more column, `unchecked`, of 1 in each row.
void write_setpoints(std::ostream& out, const std::vector<Setpoint>& setpoints, SetpointAxes axes,
                     bool checked = true);

// The rows of either table, checked or not, in ENU. Throws geom::InputError(source, line, …) for
// another header, a row that is not 12 finite numbers, times that do not grow, fewer than two rows,
// and a last line without its end, which may have lost digits.
std::vector<Setpoint> read_setpoints(std::istream& in, std::string_view source);

}  // namespace traj
