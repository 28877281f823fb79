#pragma once

// Trees over boxes, built by Embree.

#include <span>

#include "box_tree.h"

namespace geom {

// Splits are those of the least surface area, in bins (Wald 2007), and up to sixteen boxes share a
// leaf. Of at least one box and less than 2^31 - 1. Throws std::bad_alloc, and std::runtime_error
// where Embree cannot build at all: what goes wrong inside Embree, which as a C library keeps it to
// itself. Threads may build at once.
// `frame` is of the boxes or of more.
BuiltTree embree_tree(std::span<const Aabb> boxes, const TreeFrame& frame);
inline BuiltTree embree_tree(std::span<const Aabb> boxes) {
  return embree_tree(boxes, TreeFrame(*bounds(boxes)));
}

// Starts Embree, once in a process. Throws where it did not start, each time.
void start_embree();

}  // namespace geom
