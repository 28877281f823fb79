#pragma once

// --proved-tube: solves until the map is clear with the proved tube of the result.

#include "cli/option/scenes.h"
#include "options.h"
#include "traj/record/solve_in_tube.h"

namespace solving {

class TubeSolver {
 public:
  // `options` and `scenes` must outlive this. Throws cli::UsageError for a vehicle or options that
  // no proof speaks of.
  TubeSolver(const Options& options, cli::Scenes& scenes);

  // For a path of the source, whose scene is of `scenes`. Threads may call at once.
  traj::TubeSolved solve(const geom::PathRecord& path, const std::string& source, std::size_t line);

 private:
  const Options& options_;
  cli::Scenes& scenes_;
  traj::TubeTask task_;
  geom::Scenes rooms_;  // with the margins of the rounds
};

}  // namespace solving
