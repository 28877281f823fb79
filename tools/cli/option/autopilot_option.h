#pragma once

// --autopilot, --params, --navigation and --tracking: what flies a file, and how well.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "traj/flight/vehicle_profile.h"
#include "traj/mission/formats/flier.h"

namespace cli {

struct AutopilotOptions {
  std::string word = "any";         // --autopilot
  std::string params = {};          // --params
  std::optional<double> drag = {};  // --drag
  traj::Flier flier = {};           // --navigation and --tracking; settle() gives the rest

  void add_to(CLI::App& app);
  void add_reading_to(CLI::App& app);  // of these, what decides how a file is read
  void add_tracking_to(CLI::App& app);

  // Reads the parameters; takes navigation and drag of the profile where no option says them. Once,
  // before anything else is asked.
  void settle(const std::optional<traj::VehicleProfile>& profile);
};

}  // namespace cli
