#pragma once

// The outline of a zone's volume on a map.

#include <string>

#include "geom/map/box_map.h"
#include "geom/shape/polygon.h"
#include "geom/zone/sun_times.h"
#include "geom/zone/zone.h"

namespace geom::zone {

// Along the map's axes. The true edges are within `bulge` metres of those of the polygon.
struct PlacedOutline {
  Polygon polygon;
  double bulge = 0;
};

// The area of a map's bounds in degrees, a little larger; longitudes are near the origin's.
SunArea area_of(const BoxMapSpec& spec);

// The area of an outline, as far from the origin's longitude as it is, with all readings of its
// edges.
SunArea area_of(const GeodeticOutline& outline, double longitude);

bool apart(const SunArea& a, const SunArea& b);

// Throws InputError(source, …) where it reaches too far from the origin.
PlacedOutline placed(const ZoneVolume& volume, const Frame& frame, const std::string& item,
                     const std::string& source);

}  // namespace geom::zone
