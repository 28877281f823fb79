#pragma once

// Between a roadmap in tiles and one whose bends are numbered one after the other.

#include <cstddef>

#include "edge_lists.h"
#include "plan/roadmap/roadmap.h"
#include "tile_bends.h"

namespace plan {

// Of tiles [begin, end) of `bends`. `edges` are those of their bends, sorted as Roadmap says, to
// all of `bends`.
Roadmap tiled(const RoadmapSpec& spec, const TileBends& bends, std::size_t begin, std::size_t end,
              EdgeLists edges, unsigned threads);

struct FlatRoadmap {
  TileBends tiles;
  EdgeLists edges;
};

// All of a roadmap. Throws geom::InputError for what no roadmap says.
FlatRoadmap flattened(const Roadmap& roadmap);

}  // namespace plan
