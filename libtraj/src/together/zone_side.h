#pragma once

// Pieces of a relative curve against a zone, rounded to the side of caution.

#include "curve/curve_piece.h"
#include "traj/together/spacing.h"

namespace traj {

// Whether all control points, each moved by up to `off` along each axis, lie strictly beyond one
// plane that has the whole zone on its other side; then so does the curve.
bool beyond(const Zone& zone, const Points<kPoints>& q, double off);

// Whether the point surely lies in the zone, wherever within `off` of `p` along each axis it is.
bool within(const Zone& zone, const Vec3& p, double off);

// At most share_of() anywhere in the box. Rounded: for reports.
double least_share(const Zone& zone, const geom::Aabb& box);

// The direction from zero, in plan, to what is nearest of the line between the ends of a piece:
// where an upright plane is tried. Zero where there is none.
Eigen::Vector2d nearest_direction(const Points<kPoints>& q);

}  // namespace traj
