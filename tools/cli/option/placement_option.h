#pragma once

// --origin, --geoid, --ground, --takeoff-height and --heading: where a drone file's coordinates
// count from.

#include <CLI/CLI.hpp>

#include "traj/mission/formats/placement.h"

namespace cli {

// `placement` must outlive the app.
void add_origin(CLI::App& app, traj::Placement& placement);     // --origin and --geoid
void add_ground(CLI::App& app, traj::Placement& placement);     // --ground
void add_placement(CLI::App& app, traj::Placement& placement);  // all

}  // namespace cli
