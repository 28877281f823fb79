#pragma once

// --quality of those tools that plan.

#include <CLI/CLI.hpp>

#include "plan/planner/plan.h"

namespace cli {

void add_quality(CLI::App& app, plan::Quality& quality);

}  // namespace cli
