#pragma once

// The words that name how a trajectory is solved, and the limits it is solved for.

#include <map>
#include <optional>
#include <string>

#include "cli/vehicle_option.h"
#include "traj/solve.h"

namespace cli {

extern const std::map<std::string, traj::CorridorKind> kCorridors;

// Sets what --solver (auto, closed, ipopt, stop-and-go) and --times (stops, distance, cautious,
// trapezoid, optimised; empty: not given) say together; UsageError for another word, and where they
// contradict each other.
void choose_solver(const std::string& solver, const std::string& times,
                   traj::SolveOptions& options);

// What was asked, where it was, else what the profile says. UsageError where that is too little to
// solve for.
traj::Limits limits_to_solve(const traj::Limits& asked,
                             const std::optional<VehicleProfile>& profile);

}  // namespace cli
