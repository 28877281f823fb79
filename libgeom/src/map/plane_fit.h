#pragma once

// The plane through the corners of a surface.

#include <vector>

#include "geom/base/vec3.h"
#include "geom/map/footprint.h"

namespace geom {

// The height over plan that comes nearest to a surface's corners (least squares), and how the
// corners lie about it. Any surface that a triangulation of the corners may give is within
// `residual` of it.
struct PlaneFit {
  Vec2 centre = Vec2::Zero();
  double base = 0;  // the height over the centre
  Vec2 gradient = Vec2::Zero();
  double residual = 0;  // metres, rounded up
  double low = 0;       // of all corners
  double high = 0;
  Vec2 along = Vec2::UnitX();  // the direction in plan in which the corners are spread most
  Vec2 across = Vec2::UnitY();
  double across_low = 0;  // of the corners, from the centre
  double across_high = 0;

  double operator()(const Vec2& p) const { return base + gradient.dot(p - centre); }
  double thickness() const { return across_high - across_low; }
};

// All corners of a footprint with heights: those of the outer ring, then those of each hole.
std::vector<Vec3> corners_of(const Footprint& footprint);

PlaneFit fit_plane(const std::vector<Vec3>& corners);

// Whether a surface is so thin in plan that it is taken as a wall.
bool is_upright(const PlaneFit& plane, double slack);

}  // namespace geom
