#pragma once

// What a mission for DJI's aircraft may be asked to say.

#include <CLI/CLI.hpp>
#include <optional>

#include "traj/mission/dji/dji_mission.h"

namespace exporting {

// --wpml-version, --aircraft, --turns, --takeoff-place, --lost-link and --gimbal.
void add_dji_options(CLI::App& app, traj::DjiOptions& options, std::optional<double>& turns);

}  // namespace exporting
