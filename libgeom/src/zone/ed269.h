#pragma once

// Zones of EUROCAE ED-269, chapter 8: UASZoneVersion with airspace volumes.

#include "geom/zone/zone.h"
#include "zone_fields.h"

namespace geom::zone {

// Whether the value is a list of such zones, or an object with one ("features", "UASZoneList").
bool is_ed269(const Json& root);

// Throws InputError (read_zones.h).
ZoneFile read_ed269(const Json& root, const std::string& source);

}  // namespace geom::zone
