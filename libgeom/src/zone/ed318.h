#pragma once

// Zones of EUROCAE ED-318: GeoJSON features whose geometries have layers.

#include "geom/zone/zone.h"
#include "zone_fields.h"

namespace geom::zone {

// Whether the value is a FeatureCollection whose first feature has a zone's properties.
bool is_ed318(const Json& root);

// Throws InputError (read_zones.h).
ZoneFile read_ed318(const Json& root, const std::string& source);

}  // namespace geom::zone
