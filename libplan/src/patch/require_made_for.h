#pragma once

// Whether an artefact of an older map can be patched for a scene.

#include "geom/collision/collision.h"
#include "geom/record/record.h"

namespace plan {

// Throws geom::InputError(kind, …) where frame, vehicle or margin are not the scene's.
void require_made_for(const geom::Provenance& made_for, const geom::CollisionScene& scene,
                      const char* kind);

}  // namespace plan
