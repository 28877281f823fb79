#pragma once

// Outlines around boxes that touch, for drawings in plan.
//
// Example:
//   const std::vector<geom::Aabb> boxes = {
//       {{0, 0, 0}, {2, 1, 1}}, {{2, 0, 0}, {4, 1, 1}}, {{9, 0, 0}, {10, 1, 1}}};
//   const auto rings = geom::joined_outlines(boxes, {.grid = 0.5, .tolerance = 0.1});
//   assert(rings.size() == 2 && rings[0].size() == 4);

#include <span>
#include <vector>

#include "geom/shape/aabb.h"
#include "geom/shape/polygon.h"

namespace geom {

struct OutlineDetail {
  double grid = 0.1;       // metres (> 0): corners are moved to points of this grid
  double tolerance = 0.1;  // metres (>= 0): a corner nearer than this to the line drawn is left out
};

// Rings around the union of the boxes in plan: outer ones counterclockwise, those of holes
// clockwise; together they bound it by either rule of filling. No part of the union is farther than
// grid + tolerance from what is filled, and no part of what is filled from the union. A box smaller
// than the grid is drawn as one square of it. Memory: a bit for each square of the grid within the
// boxes' bounds; at most 2^34 squares (precondition). Deterministic.
std::vector<std::vector<Vec2>> joined_outlines(std::span<const Aabb> boxes,
                                               const OutlineDetail& detail);

}  // namespace geom
