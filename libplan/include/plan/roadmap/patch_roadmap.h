#pragma once

// Roadmaps brought up to a newer map, worked out anew only where boxes changed.
//
// Example:
//   const plan::Roadmap old = plan::build_roadmap(scene, {});
//   const geom::CollisionScene newer(map, vehicle, 0.2);  // of the map that has changed
//   const plan::Roadmap patched = plan::patch_roadmap(old, newer, plan::change_since(map, newer));
//
// The result is the same to the last bit as a roadmap that is built anew.

#include "geom/base/execution.h"
#include "geom/collision/collision.h"
#include "plan/patch/map_change.h"
#include "plan/roadmap/roadmap.h"

namespace plan {

// What build_roadmap(scene, old.spec, run) gives, where `old` was built so for a map that differs
// by `change`. Bends are made anew, which is quick; edges between bends that `old` has are looked
// at only where their line meets a box that changed. Builds anew where more than 100 boxes and a
// twentieth of them changed, or the boxes of the maps are in another order (by their tile sizes).
// Throws geom::InputError as build_roadmap does, and where `old` was made for another vehicle,
// margin or frame.
Roadmap patch_roadmap(const Roadmap& old, const geom::CollisionScene& scene,
                      const MapChange& change, const geom::Execution& run = {});

}  // namespace plan
