#pragma once

// The drone files of libtraj, as a table of formats beside the other tables.

#include "geom/base/format.h"

namespace cli {

// Those that --file-format names and that their beginning tells. KML, GeoJSON and binary glTF are
// sources of obstacles, too: the row of those stands for both.
geom::Formats drone_formats();

// Whether it is one of these; not where it is null.
bool is_drone_format(const geom::Format* format);

}  // namespace cli
