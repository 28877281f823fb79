#pragma once

// Joining the end of a query to a lattice.
//
// Example:
//   const plan::Lattice lattice = plan::build_lattice(scene, {.spacing = 1});
//   plan::AstarSearch search(lattice);
//   const auto start =
//       plan::visible_nodes(scene, lattice, search, {1.3, 1.2, 1.1}, plan::Rings::nearest);
//   assert(!start.empty() && start[0].cost < 1);

#include <vector>

#include "geom/collision/collision.h"
#include "plan/lattice/astar.h"
#include "plan/lattice/lattice.h"

namespace plan {

enum class Rings { nearest, all };

// Free nodes that see `p`, with their distances as costs. They are sought in the 5 rings of nodes
// around `p`, of which the innermost is the corners of its cell: those of the nearest ring that has
// any, or those of all rings. None if `p` is not free. `search` is a search on the lattice, so that
// what it has read is not read again.
std::vector<Terminal> visible_nodes(const geom::CollisionScene& scene, const Lattice& lattice,
                                    AstarSearch& search, const Vec3& p, Rings rings);

}  // namespace plan
