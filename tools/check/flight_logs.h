#pragma once

// Flight logs held against a map, and against the plan they were to follow.

#include <string>

#include "cli/option/degrees.h"
#include "cli/option/scenes.h"
#include "cli/shard/record_output.h"
#include "report_output.h"
#include "traj/record/flight_log_check.h"

namespace checking {

class FlightLogs {
 public:
  void add_to(CLI::App& app);
  // Throws cli::UsageError for options that mean nothing of a flight log, and the other way round.
  void refuse_idle(const CLI::App& app, bool asked) const;
  const std::string& plan() const { return plan_; }
  const std::string& tube() const { return tube_; }

  // What the check of the flights of a file needs.
  struct Run {
    const cli::Common& common;
    const std::string& input;
    cli::Scenes& scenes;
    const cli::MetresOption& metres;
    const cli::Sharding& sharding;
    const ReportOutput& report;
    bool override_record;  // a log need not say its map
  };

  // A report a flight.
  cli::Exit check(const Run& run) const;

 private:
  traj::FlightLogCheck read_plans(const Run& run) const;

  std::string plan_;
  std::string tube_;
  traj::SampledRule rule_;
};

}  // namespace checking
