#pragma once

// A path by random trees, where no chain leads past what stands on the straight line.

#include "geom/collision/collision.h"
#include "geom/shape/polyline.h"

namespace plan {

// The shortest of four of RRT-Connect (plan/sampling/rrt.h) with fixed seeds, which sample around
// the two places, each shortened by its own points. Empty where none was found, which proves
// nothing. The places are free and do not see each other. Deterministic.
geom::Polyline tree_path(const geom::CollisionScene& scene, const geom::Vec3& from,
                         const geom::Vec3& to);

}  // namespace plan
