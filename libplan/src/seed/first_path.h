#pragma once

// A path before any search: over or round what stands on the straight line.

#include "geom/collision/collision.h"
#include "geom/shape/polyline.h"

namespace plan {

using geom::Vec3;

// The shortest chain_in() a few half-planes beside the straight line: upright, slanting and, where
// the places are near each other, level. Looks at no more of them once it has one of at most
// `enough` times the straight line, or where they are far apart and the first three promise little.
// Empty where no half-plane has a chain. The places are free and do not see each other.
// Deterministic.
geom::Polyline first_path(const geom::CollisionScene& scene, const Vec3& from, const Vec3& to,
                          double enough);

}  // namespace plan
