#pragma once

// The bends of a roadmap by tiles, made for each square by itself.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "plan/roadmap/roadmap.h"
#include "squares.h"

namespace plan {

// Bends by squares, one square after the other in the order of code_of(); in a square in the order
// of the map's boxes. Squares without bends are left out.
struct TileBends {
  std::vector<Square> squares;
  std::vector<std::uint32_t> first{0};  // bend of each; one more than squares
  std::vector<Bend> bends;

  std::size_t tile_of(std::size_t bend) const;  // by bisection
};

// A square that may have bends, as code_of() has it, and about how many boxes are near it.
struct SquareShare {
  std::uint64_t code;
  std::uint64_t boxes;
};

// All that may have some, ascending.
std::vector<SquareShare> squares_of(const geom::CollisionScene& scene, const RoadmapSpec& spec);

// Throws geom::InputError where a square has more than 2^24 bends, or all have more than 2^31.
TileBends bends_of(const geom::CollisionScene& scene, const RoadmapSpec& spec,
                   std::span<const std::uint64_t> codes, const geom::Execution& run);

}  // namespace plan
