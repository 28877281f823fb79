#pragma once

// Boxes as triangles, for viewers.

#include <iosfwd>

#include "geom/box_map.h"

namespace geom {

// Binary little-endian PLY: 8 vertices (double) and 12 triangles a box, facing outward, in
// east-north-up axes; a colour a label.
void write_ply(std::ostream& out, const BoxMap& map);

// Binary glTF 2.0 (`.glb`): a node and mesh a label, single precision relative to the middle of the
// map (the node's translation), y up as glTF wants: x east, z south.
void write_glb(std::ostream& out, const BoxMap& map);

}  // namespace geom
