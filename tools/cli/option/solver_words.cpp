#include "solver_words.h"

#include <fmt/format.h>

#include "cli/answer/exit.h"

namespace cli {
void choose_solver(const std::string& solver, const std::string& times,
                   traj::SolveOptions& options) {
  const auto named = geom::value_of(traj::kSolverWords, solver);
  if (!named) {
    throw UsageError(fmt::format(
        "--solver: expected auto, closed, banded, ipopt or stop-and-go, found \"{}\"", solver));
  }
  options.solver = *named;
  if (times.empty()) return;
  const auto allocation = geom::value_of(traj::kTimesWords, times);
  const bool optimised =
      times == "optimised";  // the solver's own; the others are the closed form's
  if (!allocation && !optimised) {
    throw UsageError(fmt::format(
        "--times: expected stops, distance, cautious, trapezoid or optimised, found \"{}\"",
        times));
  }
  const bool fits = optimised ? solver == "ipopt" || solver == "banded" : solver == "closed";
  if (solver != "auto" && !fits) {
    throw UsageError(fmt::format("--times {} needs --solver {} or auto, found {}", times,
                                 optimised ? "banded, ipopt" : "closed", solver));
  }
  if (!optimised) options.times = allocation;
  if (optimised && solver == "auto") options.solver = traj::Solver::ipopt;
}

}  // namespace cli
