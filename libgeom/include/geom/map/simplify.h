#pragma once

// Fewer boxes that reach a little further.
//
// Example:
//   geom::BoxTable steps;
//   steps.add({{0, 0, 0}, {1, 1, 1}}, 1);
//   steps.add({{1, 0, 0}, {2, 1, 1.2}}, 2);
//   assert(geom::simplify(steps, 0.25).table.boxes.size() == 1);

#include "geom/base/execution.h"
#include "geom/map/box_map.h"

namespace geom {

struct Simplified {
  BoxTable table;
  std::size_t rounds = 0;  // of pairing
  std::size_t tried = 0;   // pairs looked at
};

// Joins near boxes of one label and of the same times into their hull where every point of the hull
// is within `slack` metres (>= 0, Euclidean) of an input box that is there at all these times: so
// each input box lies in one output box, and no output box reaches further than the slack from the
// input, in real arithmetic. Greedy: in each round every box looks for the neighbour that adds
// least volume and fits, and the best pairs are joined, until there is none. After and before
// merge(). Deterministic, for any number of threads.
Simplified simplify(BoxTable table, double slack, const Execution& run = {});

}  // namespace geom
