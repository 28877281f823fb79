#include "solver_words.h"

#include <fmt/format.h>

#include "cli/answer/exit.h"

namespace cli {
namespace {

const std::map<std::string, traj::Solver> kSolvers{{"auto", traj::Solver::automatic},
                                                   {"closed", traj::Solver::closed},
                                                   {"banded", traj::Solver::banded},
                                                   {"ipopt", traj::Solver::ipopt},
                                                   {"stop-and-go", traj::Solver::stop_and_go}};

// Those of the closed form; "optimised" is the solver's own.
const std::map<std::string, traj::Times> kTimes{{"stops", traj::Times::stops},
                                                {"distance", traj::Times::distance},
                                                {"cautious", traj::Times::cautious},
                                                {"trapezoid", traj::Times::trapezoid}};

}  // namespace

const std::map<std::string, traj::CorridorKind> kCorridors{{"planes", traj::CorridorKind::planes},
                                                           {"boxes", traj::CorridorKind::boxes}};

void choose_solver(const std::string& solver, const std::string& times,
                   traj::SolveOptions& options) {
  const auto named = kSolvers.find(solver);
  if (named == kSolvers.end()) {
    throw UsageError(fmt::format(
        "--solver: expected auto, closed, banded, ipopt or stop-and-go, found \"{}\"", solver));
  }
  options.solver = named->second;
  if (times.empty()) return;
  const auto allocation = kTimes.find(times);
  const bool optimised = times == "optimised";
  if (allocation == kTimes.end() && !optimised) {
    throw UsageError(fmt::format(
        "--times: expected stops, distance, cautious, trapezoid or optimised, found \"{}\"",
        times));
  }
  const bool fits = optimised ? solver == "ipopt" || solver == "banded" : solver == "closed";
  if (solver != "auto" && !fits) {
    throw UsageError(fmt::format("--times {} needs --solver {} or auto, found {}", times,
                                 optimised ? "banded, ipopt" : "closed", solver));
  }
  if (!optimised) options.times = allocation->second;
  if (optimised && solver == "auto") options.solver = traj::Solver::ipopt;
}

}  // namespace cli
