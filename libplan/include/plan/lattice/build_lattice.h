#pragma once

// Lattices of a map: the grown boxes put onto a grid, all at once or where a search needs them.
//
// Example:
//   const plan::Lattice lattice =
//       plan::build_lattice(scene, {.spacing = 1, .connectivity = plan::Connectivity::twenty_six});
//   std::cout << lattice.counts().nodes << " free nodes\n";

#include "geom/base/execution.h"
#include "geom/collision/collision.h"
#include "plan/lattice/lattice.h"

namespace plan {

// The lattice of all nodes inside the scene's free bounds and, where given, `within` (both closed);
// only the tiles near `within` are then touched. Exact: nodes and axis-parallel edges by comparing
// doubles, diagonal ones by geom::segment_hits. Blocks that are all free or all blocked take 4
// bytes, others 256 (6 neighbours) or 1024. The same for any number of threads. Throws
// geom::InputError where it would have more than 2^40 nodes, or none.
Lattice build_lattice(const geom::CollisionScene& scene, const LatticeSpec& spec,
                      const geom::Execution& run = {},
                      const std::optional<geom::Aabb>& within = std::nullopt);

// The same lattice. Each block is computed each time it is read. The scene must outlive the
// lattice.
Lattice lazy_lattice(const geom::CollisionScene& scene, const LatticeSpec& spec,
                     const std::optional<geom::Aabb>& within = std::nullopt);

}  // namespace plan
