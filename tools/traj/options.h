#pragma once

// The options of skyway-traj that say what to solve for, and how.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "cli/option/degrees.h"
#include "cli/option/limit_options.h"
#include "cli/option/simulated_vehicle.h"
#include "geom/record/agreed_room.h"
#include "traj/curve/yaw.h"
#include "traj/solve/solve.h"

namespace solving {

// What is asked of a path.
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
  cli::MetresOption metres;
  bool proved_tube = false;
  std::string report_file;  // of proved tubes; empty: none
  cli::SimulatedVehicleOptions flown;

  void add_to(CLI::App& app);

  // Throws cli::UsageError for options of proved tubes that do not go together.
  void require_sound(const CLI::App& app) const;

  // Once parsed: what --solver and --times say together; throws cli::UsageError.
  void choose_solver();

  // What a trajectory of that vehicle would be held to; throws cli::UsageError for a wrong yaw.
  geom::Limits limits_for(const geom::Vehicle& vehicle) const;

  // For a path of that vehicle. Throws cli::UsageError for limits as geom::limits_to_solve does,
  // and for a wrong yaw.
  Task task(const geom::Vehicle& vehicle) const;
};

}  // namespace solving
