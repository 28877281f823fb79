#pragma once

// Polygons and circles that are given on the Earth, as polygons on a map.
//
// Example:
//   const geom::GeodeticOutline circle{.centre = {47.4, 8.5, 0}, .radius = 50};
//   const geom::MapOutline outline = geom::outline_on_map(
//       circle, {47.4, 8.5, 0}, geom::CircleSide::around, "a fence", "mission.plan");
//   assert(outline.ring.size() == 256 && outline.bulge < 0.01);

#include <string_view>
#include <vector>

#include "geom/map/geographic_frame.h"
#include "geom/shape/polygon.h"

namespace geom {

// A polygon, or a circle. Heights of places mean nothing.
struct GeodeticOutline {
  std::vector<GeodeticPlace> ring;  // empty: a circle
  GeodeticPlace centre;
  double radius = 0;  // m along the ellipsoid
};

// A simple polygon in ENU about an origin, metres.
struct MapOutline {
  std::vector<Vec2> ring;
  double bulge = 0;  // how far the true edges may be from these
};

// On which side of a circle the polygon lies that stands for it.
enum class CircleSide { around, within };

// A circle becomes a polygon of 256 corners, at most 0.0075 % of its radius off it. Some take edges
// as straight in degrees, others as shortest ways (geodesics), others as straight in metres; and a
// map's metres grow away from its origin. `bulge` bounds all of it, and edges of 200 m leave 2 mm.
// `what` names it in messages: "a fence". Throws InputError(source, …) for a ring of fewer than 3
// places or with crossing edges, a radius that is not above 0 or beyond 100 km, and a place that is
// not near the origin.
MapOutline outline_on_map(const GeodeticOutline& outline, const GeodeticOrigin& origin,
                          CircleSide side, std::string_view what, std::string_view source);

// Whether that is a place on Earth within 10 degrees of latitude and 20 of longitude of the origin.
bool is_near(const GeodeticOrigin& origin, double latitude, double longitude);

}  // namespace geom
