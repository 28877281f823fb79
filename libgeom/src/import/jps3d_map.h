#pragma once

// Voxel maps of jps3d (KumarRobotics): a YAML list of origin, dim, resolution and data.

#include <cstddef>
#include <iosfwd>
#include <string_view>

#include "geom/map/box_table.h"

namespace geom {

struct Jps3dOptions {
  bool unknown_blocked = false;  // cells below 0 become boxes labelled "unknown"
};

struct Jps3dMap {
  BoxTable table;             // a box a cell; ids are indices into data
  Aabb bounds;                // of the whole grid
  std::size_t unknown = 0;    // cells below 0: never seen
  double largest_change = 0;  // metres that rounding outward moved a face by, at most
};

// Lines `- KEY: VALUE` (or `KEY: VALUE`), where a value is a number or numbers between [ and ],
// perhaps over several lines; # starts a comment. origin (3 coordinates of the grid's lower
// corner), dim (3 counts), resolution (metres, > 0) and data, x fastest, are needed; above 0 is
// occupied, 0 free, below 0 unknown. start and goal are no obstacles. Throws InputError(source,
// line, …) for other YAML, other keys, a key that comes twice, numbers that are not finite, two
// dimensions, data of another count than dim says, and a map without boxes.
Jps3dMap read_jps3d_map(std::istream& in, std::string_view source, const Jps3dOptions& options);

struct BoxFormat;
extern const BoxFormat kJps3d;  // of box_formats()

}  // namespace geom
