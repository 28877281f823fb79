#pragma once

// The boxes of a table in the order of a map: by tile, and in each tile by coordinates.

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "box_map_data.h"
#include "geom/map/box_table.h"

namespace geom {

struct SortedBoxes {
  std::vector<Tile> tiles;
  std::shared_ptr<const BoxMap::Data::Owned> boxes;
};

using TakeBoxes = std::function<void(std::span<const Aabb>)>;

// Boxes that are equal stand by id, then by time, then as in the table. The same for any number of
// threads. Calls `take` with all boxes, a part at a time, by min, then max, whatever their tiles:
// the order in which a map is summed up (hash.h).
SortedBoxes sorted_by_tile(const BoxTable& table, double tile_size, const Execution& run,
                           const TakeBoxes& take);

// The map of a table, made on all threads; else as the constructor of BoxMap.
BoxMap box_map_of(BoxMapSpec spec, const BoxTable& table, const Execution& run);

}  // namespace geom
