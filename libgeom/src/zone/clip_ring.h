#pragma once

// Rings cut to a rectangle.

#include <vector>

#include "geom/shape/cover.h"

namespace geom::zone {

// The ring within the rectangle: inside it, each point has the winding number that it had. Along
// the rectangle's sides edges may run twice. Corners that are made are off by rounding alone. By
// I. Sutherland and G. Hodgman, "Reentrant polygon clipping", CACM 17(1), 1974.
std::vector<Vec2> clipped(std::vector<Vec2> ring, const Rectangle& within);

// Empty where the outer ring is.
Polygon clipped(const Polygon& polygon, const Rectangle& within);

}  // namespace geom::zone
