#pragma once

// Moving AI `.3dmap` voxel worlds (Brewer and Sturtevant, SoCS 2018).

#include <iosfwd>
#include <string_view>

#include "geom/map/box_map.h"

namespace geom {

struct VoxelMap {
  BoxTable table;  // voxel (x, y, z) is the unit box [x, x + 1] x …; ids are line numbers
  Aabb bounds;     // the whole grid
};

// `voxel X Y Z` with the size of the grid, then one filled voxel `x y z` a line. Throws
// InputError(source, line, …) for another first line, a field that is not a whole number, a voxel
// outside the grid, and a grid without filled voxels.
VoxelMap read_voxel_3dmap(std::istream& in, std::string_view source);

struct BoxFormat;
extern const BoxFormat kVoxelMap;  // of box_formats()

}  // namespace geom
