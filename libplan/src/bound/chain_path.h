#pragma once

// From a chain of parts to a path: where a bound that will not close says that a shorter one may
// run.

#include <vector>

#include "convex_edges.h"
#include "geom/shape/polyline.h"

namespace plan {

// A millimetre outside of the edge, at the middle of the part; a corner itself.
Vec3 beside_middle(const EdgePart& part);

// A short path from `from` over the parts in turn to `to`: its bends slid along the parts, and put
// a millimetre outside of the edges. It may hit anything.
geom::Polyline chain_path(const std::vector<EdgePart>& parts, const Vec3& from, const Vec3& to);

}  // namespace plan
