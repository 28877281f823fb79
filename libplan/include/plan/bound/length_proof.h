#pragma once

// Why no path is shorter than a bound, in numbers that anyone can follow.
//
// No example: LengthBound::proof (plan/bound/bound.h) has one, and BoundRecord writes it.
//
// docs/certificates.md has the conditions.

#include <array>
#include <cstdint>
#include <vector>

#include "geom/shape/aabb.h"

namespace plan {

struct LengthProof {
  // A stretch of an edge, or a place (low == high, axis 3): see libplan/src/bound/convex_edges.h.
  struct Part {
    geom::Vec3 low;
    geom::Vec3 high;
    std::uint8_t axis = 3;
    std::array<std::int8_t, 2> outward{};
    std::uint32_t parent = 0;  // of the level before; of the first level nothing
  };
  // Lower bounds on the length of ways that come to a part from each of its sides, or that go on
  // after coming from there: lines over the part, by their values at low and high. Infinite if no
  // path shorter than the bound comes so.
  using Lines = std::array<double, 4>;
  // No segment between the two parts is free of the occluder.
  struct Hidden {
    std::uint32_t from = 0;
    std::uint32_t to = 0;
    std::uint32_t occluder = 0;
  };
  struct Level {
    std::vector<Part> parts;  // the start, the goal, then the others
    std::vector<Lines> come;  // of each part: from the start
    std::vector<Lines> go;    // … to the goal; none of the last level where `come` is enough
    std::vector<Hidden> hidden;
  };
  std::vector<geom::Aabb> occluders;  // inside the union of the grown boxes
  std::vector<Level> levels;          // none: the straight line is the bound
};

}  // namespace plan
