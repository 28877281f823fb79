#pragma once

// OctoMap's binary trees (`.bt`), read by liboctomap.

#include <iosfwd>
#include <string_view>

#include "geom/map/box_map.h"

namespace geom {

struct OctomapOptions {
  bool unknown_blocked = false;  // cells that were never seen become boxes labelled "unknown"
};

struct Octomap {
  BoxTable table;            // a box a leaf; ids count the boxes of the tree from 0
  Aabb bounds;               // of all cells seen, free or occupied
  double resolution = 0;     // metres, of the smallest cell
  std::size_t occupied = 0;  // leaves
  std::size_t free = 0;      // leaves
  std::size_t unknown = 0;   // cells within the bounds that were never seen (octree cells, clipped)
};

// Throws InputError(source, …) for another kind of file, a resolution that is not a positive
// number, a tree that is cut short, deeper than OctoMap's 16 levels or followed by more bytes, an
// inner node without children, and a tree without occupied cells (with unknown_blocked: without
// cells).
Octomap read_octomap(std::istream& in, std::string_view source, const OctomapOptions& options);

struct BoxFormat;
extern const BoxFormat kOctomapTree;  // of box_formats()

}  // namespace geom
