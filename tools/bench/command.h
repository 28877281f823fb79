#pragma once

// Anybody's planner: a shell command, queries in and path records out.

#include <functional>
#include <string>
#include <vector>

#include "geom/base/execution.h"
#include "geom/record/record.h"
#include "plan/bench/trial.h"

namespace bench {

// What a command wrote, and what it took.
struct CommandOutput {
  std::vector<std::string> lines;  // of its stdout, without blank ones
  double seconds = 0;              // wall, from its start to its end
  std::size_t peak_rss = 0;        // bytes: of the largest of its processes
  int status = 0;                  // exit code, or 128 and the signal
};

// Runs `command` by the shell. Its stderr is ours. Throws std::system_error where it can't be
// started; calls `progress` with the lines read so far, of `expected`.
CommandOutput run_command(const std::string& command, const std::string& input,
                          std::size_t expected, const geom::Execution& run);

std::string to_json_lines(const std::vector<geom::PlanQuery>& queries);

// Answers matched by id. Every trial takes the mean of the whole time. Throws InputError for a line
// that is no path record; `check` may do so for records made for another map or vehicle.
plan::bench::Run judge_command(
    const std::string& command, const CommandOutput& output, const geom::CollisionScene& scene,
    const std::vector<geom::PlanQuery>& queries,
    const std::function<void(const geom::PathRecord&, std::size_t line)>& check);

}  // namespace bench
