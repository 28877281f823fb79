#pragma once

// Moving a blocked or outside end of a query to the nearest free place.

#include <optional>

#include "geom/collision/collision.h"

namespace plan {

// The nearest free point within `radius` metres of `p` (closed), with faces of obstacles taken 1 mm
// outside, so that narrower gaps do not count. Nothing when there is none. `p` itself when it is
// free. Where more than 40 faces an axis lie within the distance, the furthest of them are left
// out.
std::optional<geom::Vec3> nearest_free(const geom::CollisionScene& scene, const geom::Vec3& p,
                                       double radius);

}  // namespace plan
