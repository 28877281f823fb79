#pragma once

// Shortening a path by the straight lines between its own points.

#include "geom/collision/collision.h"
#include "geom/shape/polyline.h"

namespace plan {

// The shortest chain of free segments over the path's points, and then over points in between too,
// until a round gains less than 1 mm (at most `rounds` of these). Deterministic. Every segment of
// the result has passed scene.free(), as those of `path` must have. Cost: quadratic in the points
// of a round, which are at most 120 or the path's own.
geom::Polyline shortcut(const geom::CollisionScene& scene, const geom::Polyline& path,
                        int rounds = 6);

// `path` cut into parts of at most `step` metres, each checked again: where rounding of a cut point
// puts a part in touch, its segment stays whole.
geom::Polyline resample_free(const geom::CollisionScene& scene, const geom::Polyline& path,
                             double step);

}  // namespace plan
