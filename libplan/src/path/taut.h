#pragma once

// Pulling a path taut over the boxes that it bends around.

#include "geom/collision/collision.h"
#include "geom/shape/polyline.h"

namespace plan {

struct TautOptions {
  int rounds = 50;     // at most
  double gain = 1e-3;  // metres: a round that gains less is the last
};

// A path of the same ends, no longer than `path`, whose every leg has passed scene.free(), as those
// of `path` must have. At each bend the triangle with its neighbours is cut by the boxes in it, and
// the bend becomes the convex chain around what they cut; then bends slide along the axes to where
// the unfolded path is straight. Bends keep 1 mm from the boxes, so that a
// trajectory along the path has room to be sampled and rounded. A local optimum: of ways round
// on other sides it knows nothing. Deterministic.
geom::Polyline taut(const geom::CollisionScene& scene, const geom::Polyline& path,
                    const TautOptions& options = {});

}  // namespace plan
