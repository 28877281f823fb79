#pragma once

// Whether a vehicle may be anywhere in a region, or fly from anywhere in it straight to a place.

#include <optional>

#include "geom/collision/collision.h"
#include "traj/home/prism.h"

namespace traj {

// Whether the closed prism is inside the bounds and clear of all grown boxes. `stands_on`: the z of
// a ground that it goes down to; obstacles that are no higher are stood on, and the lower bound
// does not count. Sound: planes separate, nothing is sampled.
bool clear_region(const geom::CollisionScene& scene, const Prism& region,
                  const std::optional<double>& stands_on = {});

// The same of the convex hull of a prism and the point `to`.
bool clear_join(const geom::CollisionScene& scene, const Prism& from, const Vec3& to,
                const std::optional<double>& stands_on = {});

}  // namespace traj
