#pragma once

// --vehicle and --margin.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "agreed_room.h"
#include "vehicle_word.h"

namespace cli {

struct VehicleOptions {
  std::string word;              // --vehicle
  std::optional<double> margin;  // --margin
  double spare = 0;              // --spare

  void add_to(CLI::App& app);
  void add_spare_to(CLI::App& app);
  std::optional<traj::VehicleProfile> profile() const;
  AskedRoom asked(
      const std::optional<traj::VehicleProfile>& profile) const;  // with what profile() gave
};

}  // namespace cli
