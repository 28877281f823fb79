#pragma once

// The files that drones and ground stations fly, as a table of formats.

#include "geom/base/format.h"

namespace cli {

// Those that --file-format names and that their beginning tells.
geom::Formats drone_formats();

// Whether it is one of these; not where it is null.
bool is_drone_format(const geom::Format* format);

extern const geom::Format kWplMission;
extern const geom::Format kQgcPlan;

}  // namespace cli
