#pragma once

// Few boxes that stand for many in a picture from far away.
//
// Example:
//   const std::vector<geom::Aabb> stairs = {
//       {{0, 0, 0}, {1, 9, 8}}, {{1, 0, 0}, {2, 9, 8.2}}, {{2, 0, 0}, {3, 9, 8.3}}};
//   assert(geom::far_blocks(stairs, 16).size() == 1);

#include <span>
#include <vector>

#include "geom/shape/aabb.h"

namespace geom {

// Boxes that hold all boxes, and no point of which is 2 * `cell` metres (> 0) or more away from
// one: in a picture whose pixels are as large as a cell the two look alike, and nothing is left
// out. In every square of a grid of cells the boxes above one another become one where less than a
// cell is between them; and level squares side by side become one. A box of two cells and more on
// both sides stays as it is. Deterministic.
std::vector<Aabb> far_blocks(std::span<const Aabb> boxes, double cell);

}  // namespace geom
