#pragma once

// Setpoints at a fixed rate, as CSV: what a streaming client sends to the autopilot.

#include <iosfwd>
#include <string_view>

#include "geom/frame.h"
#include "traj/trajectory.h"

namespace traj {

// Header `t_s,x_m,y_m,z_m,vx_m_s,vy_m_s,vz_m_s,ax_m_s2,ay_m_s2,az_m_s2,yaw_rad`, in ENU axes. Rows
// at k / rate seconds (rate in Hz, > 0) and one at the very end. Yaw is 0 where none is given.
void write_setpoints(std::ostream& out, const Trajectory& trajectory, geom::Axes axes, double rate);

// The trajectory as a client flies it that holds straight lines between the written positions:
// parsed from the text, in the map's axes; degree-7 segments with their control points on the
// line. Throws geom::InputError where the text is not such a table.
Trajectory read_setpoints(std::istream& in, std::string_view source, geom::Axes axes);

}  // namespace traj
