#pragma once

// The boxes that went and those that came from an older map to a newer one.
//
// Example:
//   const plan::MapChange change = plan::change_since(map, scene);
//   assert(change.removed.empty() && change.added.empty());  // the scene is of the same map
//
// Patches of roadmaps (plan/roadmap/patch_roadmap.h) go by them.

#include <vector>

#include "geom/collision/collision.h"

namespace plan {

// Boxes that one of two maps has and the other has not, grown. A box that moved is in both lists.
struct MapChange {
  std::vector<geom::Aabb> removed;
  std::vector<geom::Aabb> added;
};

// From an older map to that of the scene, grown as the scene's. Throws geom::InputError where the
// frames differ.
MapChange change_since(const geom::BoxMap& before, const geom::CollisionScene& scene);

}  // namespace plan
