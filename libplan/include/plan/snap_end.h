#pragma once

// Moving a blocked or outside end of a query to the nearest free place.

#include <optional>

#include "geom/collision.h"

namespace plan {

// A free point within `radius` metres of `p` (closed), and no further than the best of: the faces
// of the grown obstacles around, each 1e-6 m outside, their pairwise and triple corners, and the
// nearest place inside the bounds. Nothing when none of these is free. `p` itself when it is free.
std::optional<geom::Vec3> nearest_free(const geom::CollisionScene& scene, const geom::Vec3& p,
                                       double radius);

}  // namespace plan
