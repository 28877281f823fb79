#pragma once

// A run of squares of a roadmap: its bends, those that they may be linked to, and the edges.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tile_bends.h"

namespace plan {

// [begin, end) of all squares.
struct SquareRun {
  std::size_t begin = 0;
  std::size_t end = 0;
};

// The squares whose bends may be linked to those of a run: codes, ascending.
struct SquaresAround {
  std::vector<std::uint64_t> codes;
  SquareRun own;  // of codes
};
SquaresAround around(const std::vector<SquareShare>& all, const SquareRun& run, double reach);

// Bends of the squares around a run, and which of them are its own.
struct OwnBends {
  TileBends all;
  std::size_t first_tile = 0;  // own: [first_tile, end_tile)
  std::size_t end_tile = 0;
  std::uint32_t first = 0;  // and these bends
  std::uint32_t end = 0;

  bool is_own(std::uint32_t bend) const { return bend >= first && bend < end; }
};
OwnBends own_bends(const geom::CollisionScene& scene, const RoadmapSpec& spec,
                   const SquaresAround& squares, const geom::Execution& run);

// Edges of each own bend: to later own ones, and to all that are not own.
std::vector<std::vector<std::uint32_t>> found_edges(const geom::CollisionScene& scene,
                                                    const OwnBends& own, double reach,
                                                    const geom::Execution& run);

}  // namespace plan
