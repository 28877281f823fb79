#pragma once

// RotorPy worlds: JSON with `bounds` and `blocks`, extents as xmin,xmax,ymin,ymax,zmin,zmax.

#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "geom/base/skipped.h"
#include "geom/map/box_map.h"

namespace geom {

struct WorldJson {
  BoxTable table;  // ids count the blocks from 0; a colour becomes the label "R G B"
  Aabb bounds;
  std::vector<std::string> names;  // keys that are not known and by their name no geometry
  Skipped skipped;                 // other keys: they may mean obstacles, or turn blocks
  std::size_t flat = 0;            // blocks without extent along one or two axes: kept
  std::size_t reversed = 0;  // extents whose upper end is below the lower: their box is between
};

// The keys of a course (start, goal, resolution, margin, expected_path_length) are no obstacles.
// Throws InputError(source, …) for anything that is not such a world: malformed JSON, no bounds, no
// blocks, extents that are not 6 finite numbers, and a block without any extent.
WorldJson read_world_json(std::istream& in, std::string_view source);

struct BoxFormat;
extern const BoxFormat kRotorPyWorld;  // of box_formats()

}  // namespace geom
