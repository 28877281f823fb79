#pragma once

// What every tool is run by: the one place that catches, and knows what each exit code stands for.

#include <CLI/CLI.hpp>
#include <functional>
#include <string_view>

#include "cli/answer/exit.h"
#include "cli/option/common.h"

namespace cli {

// Says why the answer is no, on stderr.
void complain(std::string_view tool, std::string_view message);

// Parses, runs `body`, lets the outputs appear, and turns whatever happens into a message and an
// exit code.
int run_tool(CLI::App& app, int argc, char** argv, const std::function<Exit()>& body);

}  // namespace cli
