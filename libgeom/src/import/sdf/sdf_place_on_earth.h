#pragma once

// What a world of SDF says of its place on Earth, and what skyway-map adds to it.

#include <optional>

#include "geom/map/frame.h"
#include "sdf_node.h"

namespace geom {

// Of <spherical_coordinates>, and the CRS of <skyway:map>. Refuses other surfaces than WGS 84's,
// other axes than east, north, up, and a heading.
Frame frame_of(const SdfNode& world);

// Of <skyway:map bounds="x0 y0 z0 x1 y1 z1">.
std::optional<Aabb> bounds_of(const SdfNode& world);

}  // namespace geom
