#pragma once

// Boxes below a surface that stands upright: a wall, a gable.

#include <vector>

#include "box_runs.h"
#include "geom/shape/aabb.h"
#include "plane_fit.h"

namespace geom {

// Boxes from the footprint's bottom up that hold every point below its surface, which is_upright(),
// none reaching further than the slack outside. Along the surface its top is followed in parts that
// rise by no more than half of overlap_of(slack); a part, over a rectangle as thick as the surface,
// is left out where `others` hold it.
std::vector<Aabb> cover_upright(const Footprint& footprint, const PlaneFit& plane, double slack,
                                const BoxRuns& others);

}  // namespace geom
