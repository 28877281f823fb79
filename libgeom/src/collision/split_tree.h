#pragma once

// A tree over boxes, split where its parts have the least surface.

#include <span>

#include "box_tree.h"

namespace geom {

// Splits are those of the surface area heuristic, in bins (Wald 2007), and up to sixteen boxes
// share a leaf. Takes at least one box and less than 2^31 - 1; `frame` is of the boxes or of more.
// Throws std::bad_alloc. Threads may build at once.
BuiltTree split_tree(std::span<const Aabb> boxes, const TreeFrame& frame);
inline BuiltTree split_tree(std::span<const Aabb> boxes) {
  return split_tree(boxes, TreeFrame(*bounds(boxes)));
}

}  // namespace geom
