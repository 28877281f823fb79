#pragma once

// Boxes as GeoJSON, for web maps and GIS programs.
//
// Example:
//   const geom::Frame frame{.origin = geom::GeodeticOrigin{47.4, 8.5, 0}};
//   const geom::MadeMap made = geom::make_map(geom::table_of(map), frame, "[]", "city", {});
//   std::ostringstream out;
//   geom::write_box_geojson(out, made.map, "city");

#include <iosfwd>
#include <string_view>

#include "geom/map/box_map.h"

namespace geom {

// A FeatureCollection (RFC 7946: WGS 84, counter-clockwise), a feature a line and box in the map's
// order: a Polygon of its four corners with the properties id, label (where there is one), base and
// height, metres above the map's zero and above the base. Corners have nine decimals of a degree, a
// tenth of a millimetre; sides between them are straight in degrees. Throws InputError(source, …)
// where the map does not say where it is on Earth.
void write_box_geojson(std::ostream& out, const BoxMap& map, std::string_view source);

}  // namespace geom
