#pragma once

// Missions of DJI as what they make an aircraft fly over a map.

#include <istream>
#include <string>
#include <vector>

#include "cli/content/drone_file.h"

namespace cli {

// In ENU. Adds to `notes` which take-off was assumed, and what is left out. Throws as
// read_drone_file.
traj::Flown flown_dji_file(std::istream& in, const std::string& source,
                           const DroneFileOptions& options, const geom::Frame& frame,
                           std::vector<std::string>& notes);

}  // namespace cli
