#pragma once

// Lattices and roadmaps of an older map brought up to a newer one: worked out anew only where boxes
// changed, and the same to the last bit as if built anew.

#include <optional>
#include <vector>

#include "geom/base/execution.h"
#include "geom/collision/collision.h"
#include "plan/lattice/lattice.h"
#include "plan/roadmap/roadmap.h"

namespace plan {

// Boxes that one of two maps has and the other has not, grown. A box that moved is in both lists.
struct MapChange {
  std::vector<geom::Aabb> removed;
  std::vector<geom::Aabb> added;
};

// From an older map to that of the scene, grown as the scene's. Throws geom::InputError where the
// frames differ.
MapChange change_since(const geom::BoxMap& before, const geom::CollisionScene& scene);

// What build_lattice(scene, old.spec(), run, within) gives, where `old` was built so for a map that
// differs by `change`: blocks away from what changed are copied. `old` was built or read, not lazy.
// Throws geom::InputError where it has other nodes than that would have (other bounds), or was made
// for another vehicle, margin or frame.
Lattice patch_lattice(const Lattice& old, const geom::CollisionScene& scene,
                      const MapChange& change, const geom::Execution& run = {},
                      const std::optional<geom::Aabb>& within = std::nullopt);

// What build_roadmap(scene, old.spec, run) gives, where `old` was built so for a map that differs
// by `change`. Bends are made anew, which is quick; edges between bends that `old` has are looked
// at only where their line meets a box that changed. Builds anew where more than 100 boxes and a
// twentieth of them changed, or the boxes of the maps are in another order (by their tile sizes).
// Throws geom::InputError as build_roadmap does, and where `old` was made for another vehicle,
// margin or frame.
Roadmap patch_roadmap(const Roadmap& old, const geom::CollisionScene& scene,
                      const MapChange& change, const geom::Execution& run = {});

}  // namespace plan
