#pragma once

// RotorPy worlds: JSON with `bounds` and `blocks`, extents as xmin,xmax,ymin,ymax,zmin,zmax.

#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "geom/box_map.h"

namespace geom {

struct WorldJson {
  BoxTable table;  // ids count the blocks from 0; a colour becomes the label "R G B"
  Aabb bounds;
  std::vector<std::string> unknown;  // keys that say nothing known
  std::size_t flat = 0;              // blocks without extent along one or two axes: kept
};

// Throws InputError(source, …) for anything that is not such a world: malformed JSON, no bounds, no
// blocks, extents that are not 6 finite numbers, an inverted box, and one without any extent.
WorldJson read_world_json(std::istream& in, std::string_view source);

}  // namespace geom
