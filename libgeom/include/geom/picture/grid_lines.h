#pragma once

// The grid on the ground: as wide as the map asks for.
//
// Example:
//   const geom::picture::GridLines grid = geom::picture::grid_lines({{0, 0, 0}, {900, 600, 50}});
//   assert(std::abs(grid.cell - 100) < 1e-9 && std::abs(grid.fine - 10) < 1e-9);

#include "geom/shape/aabb.h"

namespace geom::picture {

struct GridLines {
  double cell = 100;  // metres between the bold lines
  double fine = 10;   // and between the fine ones
};

// The largest of 1, 2 or 5 times a power of ten that is at most `length`, which is > 0 and finite.
double round_length(double length);

// Six to fifteen cells along the longer side of the region in plan, each of ten fine ones.
GridLines grid_lines(const Aabb& region);

}  // namespace geom::picture
