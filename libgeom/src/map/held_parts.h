#pragma once

// Which parts of a wall single boxes hold, without asking about each part.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geom/shape/aabb.h"
#include "geom/shape/polygon.h"

namespace geom {

// A stretch of a wall that is a rectangle in plan, below a straight upper edge.
struct WallStretch {
  struct End {
    Vec2 near;  // on one long side
    Vec2 far;   // on the other
    double top = 0;
  };
  End from;
  End to;
  double bottom = 0;
};

// `yes`: one box surely holds the part. `no`: the boxes surely do not hold the part between them,
// since none holds the near corner of its beginning.
enum class Held : std::uint8_t { no, perhaps, yes };

// Of `count` parts of equal length, in their order. A part reaches up to the edge at its higher end
// and at most `rise` (metres) further, and its corners are rounded by no more than 16 ulp.
std::vector<Held> held_parts(const WallStretch& stretch, std::size_t count, double rise,
                             std::span<const Aabb> boxes);

}  // namespace geom
