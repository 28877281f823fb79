#pragma once

// The words that name how a trajectory is solved.

#include <string>

#include "traj/solve/solve.h"

namespace cli {

// Sets what --solver (auto, closed, banded, ipopt, stop-and-go) and --times (stops, distance,
// cautious, trapezoid, optimised; empty: not given) say together; UsageError for another word, and
// where they contradict each other.
void choose_solver(const std::string& solver, const std::string& times,
                   traj::SolveOptions& options);

}  // namespace cli
