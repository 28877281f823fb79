#pragma once

// The parameters of an autopilot, as ground stations and logs keep them.
//
// Example:
//   std::istringstream in("RTL_RETURN_ALT 40\nNAV_ACC_RAD 3\n");
//   const traj::AutopilotSettings settings = traj::read_autopilot_settings(in, "copter.param");
//   const traj::SetAutopilot set = traj::set_autopilot(settings, {traj::px4()}, "copter.param");
//   assert(set.autopilot.return_height == 40);

#include <iosfwd>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "traj/mission/firmware/autopilot.h"

namespace traj {

// Names and values of a file of parameters, and what its comments say.
struct AutopilotSettings {
  std::map<std::string, double> values;
  std::string version;  // "1.15", from a comment of QGroundControl or a log; empty: not said
  std::string vehicle;  // the vehicle of such a comment: "Multi-Rotor"; empty: not said
};

// Reads PX4's and QGroundControl's `.params` (five columns between tabs: system, component, name,
// value, type), ArduPilot's `.param` (name, then value after a comma or white space) and PX4's logs
// (ULog, found out by its first bytes). Throws geom::InputError(source, line, …) for other lines, a
// value that is no finite number, and a name that comes twice with different values.
AutopilotSettings read_autopilot_settings(std::istream& in, std::string_view source);

// An autopilot with the parameters of a file, and what the file leaves to the firmware's defaults:
// "RTL_CONE_ANG 45".
struct SetAutopilot {
  Autopilot autopilot;
  std::vector<std::string> assumed;
  bool says_return_height = false;  // else that is the firmware's, too
};

// The firmware is the one whose names the file has. `asked`: the autopilots that may fly; where
// these are of one version, that version; else the file's; else the union. Throws
// geom::InputError(source, …) for a file of neither firmware or of both, of a vehicle that is no
// multirotor, of a version that is not modelled or not asked for, and for a value out of the
// firmware's range.
SetAutopilot set_autopilot(const AutopilotSettings& settings, const std::vector<Autopilot>& asked,
                           std::string_view source);

}  // namespace traj
