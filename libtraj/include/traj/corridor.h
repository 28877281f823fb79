#pragma once

// A free path as a chain of convex regions: planes that hold each piece apart from every obstacle
// near it.

#include <cstddef>
#include <vector>

#include "geom/collision.h"
#include "geom/polyline.h"
#include "traj/trajectory.h"

namespace traj {

// The free side is normal.dot(x) <= offset; |normal| = 1 up to rounding.
struct Plane {
  Vec3 normal;
  double offset = 0;
};

// A straight part of the path and the planes it lies behind.
struct CorridorPiece {
  Vec3 from;
  Vec3 to;
  std::vector<Plane> planes;
};

using Corridor = std::vector<CorridorPiece>;  // each piece starts where the one before ends

// The plane between the segment and the closed box: through the box's point nearest to the segment
// and across the line to it, or, where that gap is below 1 mm, across the best of the six
// separating axes. Its offset is the box's own support, pulled in by min(1 mm, gap / 2), so that no
// rounding puts a point of the box on the free side. `gap` is the distance along the normal,
// before pulling in; <= 0 when the segment meets the box (the plane is then worthless).
struct Separation {
  Plane plane;
  double gap = 0;
};
Separation separation(const Vec3& from, const Vec3& to, const geom::Aabb& box);

// Whether every point of the closed box is strictly off the free side.
bool behind(const geom::Aabb& box, const Plane& plane);

// Where an optimiser gets its joints: legs of up to 10 m are one piece, up to 20 m two halves,
// others 8 m, equal middles of at most 40 m, and 8 m; the first and the last piece are cut once
// more a quarter from the end where the vehicle rests. Equal neighbouring points count once. Empty
// for a path of one place.
geom::Polyline joints(const geom::Polyline& path);

// The pieces between these points, without planes.
Corridor pieces_between(const geom::Polyline& points);

// Adds to each piece the planes for all obstacles and bounds within `reach` metres of it, nearest
// first; obstacles that are behind a plane already get none. Bounds give no plane if the vehicle
// does not fit them at all.
void add_planes(const geom::CollisionScene& scene, double reach, Corridor& corridor);

// Adds planes for the obstacles and bounds that the control points of segment i, the box around
// them, meet, to piece i. Returns how many were added. As many segments as pieces.
std::size_t add_planes_met(const geom::CollisionScene& scene, const Trajectory& trajectory,
                           Corridor& corridor);

}  // namespace traj
