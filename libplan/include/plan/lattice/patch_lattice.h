#pragma once

// A lattice of an older map brought up to a newer one: worked out anew only where boxes changed,
// and the same to the last bit as if built anew.

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
