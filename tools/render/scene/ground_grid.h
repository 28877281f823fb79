#pragma once

// The grid on the ground: as wide as the map asks for.

#include "geom/shape/aabb.h"

namespace render {

struct GroundGrid {
  double cell = 100;  // metres between the bold lines
  double fine = 10;   // and between the fine ones
};

// The largest of 1, 2 or 5 times a power of ten that is at most `length`, which is > 0 and finite.
double round_length(double length);

// Six to fifteen cells along the longer side of the region in plan, each of ten fine ones.
GroundGrid ground_grid(const geom::Aabb& region);

}  // namespace render
