#pragma once

// Many boxes in tiles, with few blocks for each when it is seen from afar.
//
// Example:
//   const std::vector<geom::Aabb> boxes(2000, geom::Aabb{{0, 0, 0}, {1, 1, 1}});
//   const std::vector<std::uint32_t> building(2000, 7);
//   const auto levels = geom::detail_levels(boxes, building);
//   assert(levels.order.size() == 2000 && !levels.far.empty());

#include <cstdint>
#include <span>
#include <vector>

#include "geom/shape/aabb.h"

namespace geom {

// Blocks that stand for boxes (far_blocks.h). The blocks of a tile stand side by side, ordered by
// group.
struct FarLevel {
  double cell = 0;  // metres
  std::vector<Aabb> blocks;
  std::vector<std::uint32_t> of;     // of each block a box of its tile and group, in the new order
  std::vector<std::uint32_t> first;  // block of each tile; at the end how many blocks there are
};

struct DetailLevels {
  std::vector<std::uint32_t> order;  // of the boxes: by tile, group and number
  std::vector<std::uint32_t>
      first;                  // box of each tile, in that order; at the end how many there are
  std::vector<FarLevel> far;  // the finest first
};

// Square tiles of about 600 boxes, and levels whose cells grow from a 96th of a tile. `group` gives
// the group of each box, and a block holds boxes of one group only. There is at least one box
// (precondition). Deterministic.
DetailLevels detail_levels(std::span<const Aabb> boxes, std::span<const std::uint32_t> group);

}  // namespace geom
