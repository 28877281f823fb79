#pragma once

// RotorPy worlds: JSON with `bounds` and `blocks`, extents as xmin,xmax,ymin,ymax,zmin,zmax.

#include <iosfwd>
#include <string_view>

#include "geom/import/box_format.h"

namespace geom {

// The keys of a course (start, goal, resolution, margin, expected_path_length) are no obstacles.
// Throws InputError(source, …) for anything that is not such a world: malformed JSON, no bounds, no
// blocks, extents that are not 6 finite numbers, and a block without any extent. Ids count the
// blocks from 0, and a colour becomes the label "R G B". Keys that are not known are skipped,
// because they may mean obstacles or turn blocks; those that by their name are no geometry are
// named.
ImportedBoxes read_world_json(std::istream& in, std::string_view source);

extern const BoxFormat kRotorPyWorld;  // of box_formats()

}  // namespace geom
