#pragma once

// UAS facility maps of the FAA: cells of a grid with ceilings in feet above the ground.

#include "geom/zone/zone.h"
#include "zone_fields.h"

namespace geom::zone {

bool is_faa_grid(const Json& root);

// Two zones a cell (read_zones.h). Throws InputError.
ZoneFile read_faa_grid(const Json& root, const std::string& source);

}  // namespace geom::zone
