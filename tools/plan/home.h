#pragma once

// --home of skyway-plan: ways home for the flights of a stream, as contingencies.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "cli/option/autopilot_option.h"
#include "cli/option/degrees.h"
#include "cli/option/vehicle_option.h"
#include "cli/run.h"
#include "cli/shard/sharding.h"
#include "plan/planner/plan.h"

namespace planning {

class HomeOption {
 public:
  void add_to(CLI::App& app);  // --home, what belongs to it, and the argument of the flights
  bool asked() const { return !sites_.empty(); }
  const std::string& sites() const { return sites_; }
  std::string flights() const { return asked() ? flights_ : std::string(); }

  // Throws cli::UsageError for options that mean nothing with --home, or without it.
  void refuse_idle(const CLI::App& app) const;

  // Where things come from, and go.
  struct Run {
    const cli::Common& common;
    const std::string& map;
    const cli::VehicleOptions& vehicle;
    const cli::MetresOption& metres;
    std::optional<plan::Quality> quality;  // of planned ways; nothing: fast
    const std::string& output;
    const cli::Sharding& sharding;
  };

  // Plans for each flight of the shard, and writes what came of it.
  cli::Exit plan(const Run& run);

 private:
  std::string sites_;
  std::string flights_ = "-";
  bool local_ = false;
  std::optional<double> vmax_;  // m/s of paths
  cli::AutopilotOptions autopilot_;
};

}  // namespace planning
