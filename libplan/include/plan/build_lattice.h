#pragma once

// Building a lattice by putting the grown boxes onto it.

#include "geom/collision.h"
#include "geom/execution.h"
#include "plan/lattice.h"

namespace plan {

// The lattice of all nodes inside the scene's free bounds and, where given, `within` (both closed);
// only the tiles near `within` are then touched. Exact: nodes and axis-parallel
// edges by comparing doubles, diagonal ones by geom::segment_hits. The same for any number of
// threads. Throws geom::InputError where it would have more than 2^31 nodes, or none.
Lattice build_lattice(const geom::CollisionScene& scene, const LatticeSpec& spec,
                      const geom::Execution& run = {},
                      const std::optional<geom::Aabb>& within = std::nullopt);

}  // namespace plan
