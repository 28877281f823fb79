#pragma once

// The fences that parameters give an autopilot.

#include <string_view>

#include "traj/mission/firmware/autopilot_settings.h"

namespace traj {

// ArduPilot's fence, which is off by default, keeps a return below it (ModeRTL), and rally points
// within it (AP_Rally_Copter::is_valid).
void set_ardupilot_fence(const AutopilotSettings& settings, Autopilot& out);

// PX4's, which does more than warn from an action of 2 on. Throws geom::InputError(source, …) for
// accelerations by which it cannot work out where it would stop.
void set_px4_fence(const AutopilotSettings& settings, std::string_view source, Autopilot& out);

}  // namespace traj
