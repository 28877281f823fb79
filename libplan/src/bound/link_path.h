#pragma once

// The shortest path beside the middles of the parts of a level, along its links: A*, to which the
// labels towards the goal say how far it is at least.

#include <cstddef>

#include "geom/collision/collision.h"
#include "geom/shape/polyline.h"
#include "level.h"

namespace plan {

// Every leg is free; empty where there is no such path shorter than `limit`, or it takes more than
// `most` steps. `steps` grows by the legs that were thought of, and those asked of the scene.
geom::Polyline link_path(const geom::CollisionScene& scene, const Level& level,
                         const std::vector<LineLabel>& go, double limit, std::size_t most,
                         std::size_t& steps);

}  // namespace plan
