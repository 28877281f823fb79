#pragma once

// The same obstacles in fewer boxes.
//
// Example:
//   geom::BoxTable table;
//   table.add({{0, 0, 0}, {1, 1, 1}}, 1);
//   table.add({{1, 0, 0}, {2, 1, 1}}, 2);  // beside it, of the same height and width
//   assert(geom::merge(table).table.boxes[0] == (geom::Aabb{{0, 0, 0}, {2, 1, 1}}));

#include "geom/map/box_map.h"

namespace geom {

struct Merged {
  BoxTable table;
  // Boxes dropped because another contains them, at all times at which they are there, whatever its
  // label; and boxes that became part of a neighbour of the same label and times.
  std::size_t contained = 0;
  std::size_t joined = 0;
};

// Drops contained boxes and joins those that are equal on two axes and touch or overlap on the
// third, until neither finds anything. At each instant the union is exactly the same closed set: no
// coordinate is new. A joined box has the smallest id of its parts. O(n log n) a round.
// Deterministic.
Merged merge(BoxTable table);

}  // namespace geom
