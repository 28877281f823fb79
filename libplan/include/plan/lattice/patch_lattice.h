#pragma once

// Lattices brought up to a newer map, worked out anew only where boxes changed.
//
// Example:
//   const plan::Lattice old = plan::build_lattice(scene, {.spacing = 1});
//   const geom::CollisionScene newer(map, vehicle, 0.2);  // of the map that has changed
//   const plan::Lattice patched = plan::patch_lattice(old, newer, plan::change_since(map, newer));
//
// The result is the same to the last bit as a lattice that is built anew.

#include <optional>

#include "geom/base/execution.h"
#include "geom/collision/collision.h"
#include "plan/lattice/lattice.h"
#include "plan/patch/map_change.h"

namespace plan {

// What build_lattice(scene, old.spec(), run, within) gives, where `old` was built so for a map that
// differs by `change`: blocks away from what changed are copied. `old` was built or read, not lazy.
// Throws geom::InputError where it has other nodes than that would have (other bounds), or was made
// for another vehicle, margin or frame.
Lattice patch_lattice(const Lattice& old, const geom::CollisionScene& scene,
                      const MapChange& change, const geom::Execution& run = {},
                      const std::optional<geom::Aabb>& within = std::nullopt);

}  // namespace plan
