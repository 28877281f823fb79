#pragma once

// Boxes below a surface that slopes.

#include <vector>

#include "geom/shape/aabb.h"
#include "plane_fit.h"

namespace geom {

// Boxes from the footprint's bottom up that hold every point below its surface, none reaching
// further than the slack outside (and 2 plane.residual - slack / 2, where corners lie that far from
// a plane). `plane` is that of the footprint's corners. Each box reaches at least `margin` (metres,
// at most slack / 20) beyond what it covers. The surface is cut by level lines; between two of
// them the lower one's boxes and the upper one's overlap by overlap_of(slack) in height.
//
// What is below a convex part of the plane is convex, so the distance to it is largest at a corner
// of a box: a steep part is cut less finely where those say that the slack is kept.
std::vector<Aabb> cover_slope(const Footprint& footprint, const PlaneFit& plane, double slack,
                              double margin);

double overlap_of(double slack);

}  // namespace geom
