#pragma once

// The options of skyway-traj that say what to solve for, and how.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "cli/limit_options.h"
#include "cli/vehicle_option.h"
#include "traj/solve.h"
#include "traj/yaw.h"

namespace solving {

// What is asked of every path.
struct Task {
  traj::SolveOptions options;
  std::optional<traj::YawOptions> yaw;
};

struct Options {
  traj::SolveOptions solve;
  std::string solver = "auto";
  std::string times;          // empty: the solver's own
  std::string corridor_file;  // empty: none
  std::string yaw;            // along, degrees or X,Y; empty: none
  cli::LimitOptions limits;

  void add_to(CLI::App& app);

  // Once parsed: what --solver and --times say together; throws cli::UsageError.
  void choose_solver();

  // For a vehicle, where there is one. Throws cli::UsageError for too few limits and a wrong yaw.
  Task task(const std::optional<cli::VehicleProfile>& profile) const;
};

}  // namespace solving
