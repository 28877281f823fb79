#pragma once

// Half a plane beside the line between two places, and the shortest way round within it.

#include "geom/collision/collision.h"
#include "geom/shape/polyline.h"
#include "path/flat_chain.h"

namespace plan {

// The line from `from` to `to` bounds it, and the unit vector `up`, across the line, points into
// it. The places are apart.
struct HalfPlane {
  HalfPlane(const Vec3& from, const Vec3& to, const Vec3& up);

  Vec3 from;
  Vec3 to;
  Vec3 along;  // unit vectors
  Vec3 up;
  Vec3 normal;
  double length;  // metres between the places
};

// A free path in the half-plane: the convex chain around all boxes that it comes upon, a millimetre
// off. Where no box hangs above a gap that the path could have gone through, no path in the
// half-plane is shorter by more than these millimetres. Empty where a box reaches back over an end,
// where the chain leaves the bounds, and where it is not shorter than `than` metres. Every leg has
// passed scene.free(). Deterministic.
geom::Polyline chain_in(const geom::CollisionScene& scene, const HalfPlane& half, double than);

}  // namespace plan
