#pragma once

// Whether a vehicle may be anywhere in a hull, or fly from anywhere in it straight to a place.

#include <optional>
#include <span>

#include "geom/collision/collision.h"

namespace traj {

// Whether the closed convex hull of the points is inside the bounds and clear of all grown boxes.
// `stands_on`: the z of a ground that it goes down to; obstacles that are no higher are stood on,
// and the lower bound does not count. Sound: planes separate (geom::hull_meets), nothing is
// sampled.
bool clear_hull(const geom::CollisionScene& scene, std::span<const geom::Vec3> hull,
                const std::optional<double>& stands_on = {});

// The same of the hull of `from` and the point `to`. Faster if they are far apart.
bool clear_join(const geom::CollisionScene& scene, std::span<const geom::Vec3> from,
                const geom::Vec3& to, const std::optional<double>& stands_on = {});

}  // namespace traj
