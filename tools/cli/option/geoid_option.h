#pragma once

// --geoid-grid: the grid of a geoid by its name, or from a file.

#include <CLI/CLI.hpp>
#include <string>

#include "geom/map/geoid_grid.h"
#include "traj/mission/formats/placement.h"

namespace cli {

inline constexpr const char* kGeoidGridHelp =
    "sea level by egm96, egm2008, or a .gtx or .pgm file";

struct NamedGeoidGrid {
  geom::GeoidGrid grid;
  std::string path;
};

// "egm96", "egm2008" where a package of Debian put it, or a file. Throws UsageError, which names
// the places, where there is none, and InputError for a file that is none.
NamedGeoidGrid geoid_grid_of(const std::string& word);

// The option of tools that read or write drone files; beside --geoid it is refused.
void add_geoid_grid(CLI::App& app, traj::Placement& placement);

}  // namespace cli
