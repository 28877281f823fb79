#pragma once

// --contingencies of skyway-check: whether ways home hold, and leave out no instant of a flight.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "cli/content/drone_file.h"
#include "cli/file/files.h"
#include "cli/option/degrees.h"
#include "cli/option/scenes.h"
#include "cli/run.h"
#include "cli/shard/sharding.h"
#include "report_output.h"

namespace checking {

class Contingencies {
 public:
  void add_to(CLI::App& app);
  bool asked() const { return !file_.empty(); }
  const std::string& file() const { return file_; }
  // Throws cli::UsageError for options that mean nothing of contingencies.
  void refuse_idle(const CLI::App& app) const;

  // Settles the autopilots, and lets --margin be no less than what they stray. Throws
  // cli::UsageError where FILE is no stream of records.
  void settle(cli::DroneFileOptions& drone_file, cli::VehicleOptions& vehicle) const;

  // What the check of the flights of a stream against their contingencies needs.
  struct Run {
    const cli::Common& common;
    cli::InputFile& flights;  // trajectories or paths
    cli::Scenes& scenes;
    const cli::AutopilotOptions& autopilot;  // settled
    std::optional<double> vmax;              // m/s of paths
    const cli::MetresOption& metres;
    const cli::Sharding& sharding;
    const ReportOutput& report;
    bool exact;                      // checked once more in exact numbers
    const std::string& certificate;  // a file; empty: none
  };

  // A report a flight.
  cli::Exit check(const Run& run) const;

 private:
  std::string file_;
};

}  // namespace checking
