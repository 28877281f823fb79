#pragma once

// Rings of points whose edges do not cross.

#include <span>

#include "geom/shape/polygon.h"

namespace geom {

// Whether no two edges of the ring (the last point joined to the first) share a point but
// neighbours their common corner. Fewer than three points are none. By CGAL, exact; n log n.
bool is_simple(std::span<const Vec2> ring);

}  // namespace geom
