#pragma once

// Polygons that one rectangle covers, or a few pieces of a long one: no slabs are looked for.

#include <optional>
#include <vector>

#include "geom/shape/cover.h"

namespace geom {

// The rectangle around the polygon, where it is surely within the slack.
std::optional<Rectangle> one_rectangle(const Polygon& polygon, double slack);

// Of a long quadrilateral that leans, as rows of a raster do on another projection's plane; none of
// other polygons. `turned`: the polygon with x and y exchanged.
std::vector<Rectangle> long_pieces(const Polygon& polygon, const Polygon& turned, double slack);

}  // namespace geom
