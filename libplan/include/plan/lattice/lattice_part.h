#pragma once

// A shard of a lattice: what one of several processes builds.
//
// Example:
//   std::vector<plan::LatticePart> parts;
//   for (std::size_t i = 0; i < 3; ++i) {  // each in a process of its own
//     parts.push_back(plan::build_lattice_part(scene, {.spacing = 1}, {.index = i, .count = 3}));
//   }
//   const plan::Lattice whole = plan::join_lattice(parts);  // as build_lattice() gives it

#include <optional>
#include <span>

#include "geom/base/execution.h"
#include "geom/base/shard.h"
#include "geom/collision/collision.h"
#include "plan/lattice/lattice.h"
#include "plan/lattice/stored_blocks.h"

namespace plan {

// The masks of a run of tiles, which are columns of 4 x 4 blocks.
struct LatticePart {
  LatticeGrid grid;  // of the whole lattice
  geom::Provenance made_for;
  geom::Shard shard;
  StoredBlocks blocks;  // of the shard's tiles
};

// The shard's part of what build_lattice() gives; only the boxes near its tiles are looked at.
// Throws as build_lattice() does.
LatticePart build_lattice_part(const geom::CollisionScene& scene, const LatticeSpec& spec,
                               const geom::Shard& shard, const geom::Execution& run = {},
                               const std::optional<geom::Aabb>& within = std::nullopt);

// The lattice of all its parts, in the order of their shards: bit for bit what build_lattice()
// gives. One part alone is not copied. Throws geom::InputError where they are not the parts of one
// lattice.
Lattice join_lattice(std::span<const LatticePart> parts);

}  // namespace plan
