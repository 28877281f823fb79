#pragma once

// Anybody's planner: a shell command, queries in and path records out.

#include <string>

#include "geom/base/execution.h"
#include "plan/bench/other_planner.h"

namespace bench {

// What a command wrote, and what it took.
struct CommandOutput {
  plan::bench::AnswerLines answers;  // of its stdout
  int status = 0;                    // exit code, or 128 and the signal
};

// Runs `command` by the shell. Its stderr is ours. Throws std::system_error where it can't be
// started; calls `progress` with the lines read so far, of `expected`.
CommandOutput run_command(const std::string& command, const std::string& input,
                          std::size_t expected, const geom::Execution& run);

}  // namespace bench
