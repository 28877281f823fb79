#pragma once

// --autopilot, --params, --navigation and --tracking: what flies a file, and how well.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "traj/drone_file/mission_flight.h"
#include "traj/flight/vehicle_profile.h"

namespace cli {

// Metres that a vehicle may be from where it takes itself to be, or ought to be: in each horizontal
// direction, and up or down.
struct Uncertainty {
  double across = 0;
  double vertical = 0;
};

struct AutopilotOptions {
  std::string word = "any";                // --autopilot
  std::string params;                      // --params
  std::optional<Uncertainty> navigation;   // --navigation
  std::optional<Uncertainty> tracking;     // --tracking
  std::optional<double> drag;              // --drag
  std::vector<traj::Autopilot> pilots{};   // settle() gives them
  std::vector<std::string> assumed{};      // parameters that the file of --params leaves out
  std::optional<traj::Autopilot> exactly;  // the one whose parameters are known

  void add_to(CLI::App& app);
  void add_tracking_to(CLI::App& app);

  // Reads the parameters; takes navigation and drag of the profile where no option says them. Once,
  // before anything else is asked.
  void settle(const std::optional<traj::VehicleProfile>& profile);

  // The rules with what is known of the autopilot; what the rules say already goes before it.
  traj::MissionRules rules(traj::MissionRules rules) const;

  // Metres along each axis that the vehicle's box is larger by: navigation, and with `tracks` what
  // is allowed for tracking.
  geom::Vec3 allowance(bool tracks) const;

 private:
  void take_parameters();
};

}  // namespace cli
