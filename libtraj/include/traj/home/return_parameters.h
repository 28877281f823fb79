#pragma once

// Parameters with which an autopilot returns as it was proved, as a file that it loads.
//
// Example:
//   #include "traj/mission/firmware/autopilot_settings.h"
//   traj::Autopilot pilot = traj::px4("1.17");
//   pilot.return_height = 75;
//   std::istringstream file(traj::return_parameters(pilot, {.fenced = true}));
//   const auto read = traj::read_autopilot_settings(file, "q1.params");
//   assert(read.values.at("RTL_RETURN_ALT") == 75 && read.values.at("NAV_DLL_ACT") == 2);

#include <string>

#include "traj/mission/firmware/autopilot.h"

namespace traj {

struct ReturnParameters {
  bool fenced = false;  // fences come with the mission
};

// PX4's for QGroundControl (five columns), ArduPilot's a name and a value a line: the height, the
// least climb and the cone of the return, to home or a rally point, with a landing; and that a lost
// link to the ground station or to the remote control ends in it. ArduPilot: fences are on if there
// are any. 4.7 and later count in metres (RTL_ALT_M), versions before, and the union, in
// centimetres.
std::string return_parameters(const Autopilot& autopilot, const ReturnParameters& what);

// Where a height is too fine for the firmware's parameter, the next one above: ArduPilot keeps
// whole centimetres.
double height_as_set(const Autopilot& autopilot, double height);

}  // namespace traj
