#pragma once

// Which tiles of a map share a group, and so a tree.

#include <cstdint>
#include <vector>

#include "geom/shape/aabb.h"
#include "map/tile_table.h"

namespace geom {

struct TileGroups {
  static constexpr std::uint32_t kEnd = 0xffffffff;
  static constexpr std::size_t kMostNames = 0x7fffffff;  // no group spans as many boxes of the map

  // Boxes [first, first + count) of the map.
  struct Run {
    std::size_t first = 0;
    std::uint32_t count = 0;
    std::uint32_t next = kEnd;  // the next run of the group, further on in the map
  };

  std::vector<Run> runs;
  std::vector<std::uint32_t> head;  // of each group, the first run
  std::vector<Aabb> extent;         // of each group
};

// Squares of tiles, so that groups have about `wanted` boxes; the tile of large boxes is a group
// for itself. All tiles are one group where the map has no more than 16 times as many boxes. Tiles
// come in the order of a map. Throws InputError where an extent is further than kFarthest.
TileGroups tile_groups(const TileTable& tiles, std::size_t boxes, double wanted);

}  // namespace geom
