#pragma once

// The drone files that are read, as a table of formats beside the other tables.
//
// Example:
//   const geom::Format* script = geom::recognise("command\ntakeoff\n",
//   traj::files::drone_formats()); assert(traj::files::is_drone_format(script) && script->word ==
//   "tello");

#include "geom/base/format.h"

namespace traj::files {

// Those that --file-format names and that their beginning tells. KML, GeoJSON and binary glTF are
// sources of obstacles, too: the row of those stands for both.
geom::Formats drone_formats();

// Whether it is one of these; not where it is null.
bool is_drone_format(const geom::Format* format);

}  // namespace traj::files
