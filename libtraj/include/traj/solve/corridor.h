#pragma once

// Corridors: a free path as a chain of convex regions.
//
// Example:
//   traj::Corridor corridor = traj::pieces_between(traj::joints(path));
//   traj::add_planes(scene, 5, corridor);  // for obstacles and bounds within 5 m
//   std::cout << corridor[0].planes.size() << " planes around the first piece\n";
//
// Planes hold each piece apart from every obstacle near it.

#include <cstddef>
#include <vector>

#include "geom/collision/collision.h"
#include "geom/shape/polyline.h"
#include "geom/shape/separation.h"
#include "traj/curve/trajectory.h"

namespace traj {

using geom::Plane;
using geom::Separation;

// A straight part of the path and the planes it lies behind.
struct CorridorPiece {
  Vec3 from;
  Vec3 to;
  std::vector<Plane> planes;
};

using Corridor = std::vector<CorridorPiece>;  // each piece starts where the one before ends

// The path without legs shorter than `least` metres, as far as it stays free; both ends stay. If
// two points are that near, one is left out; at a corner that needs both, one new point replaces
// both, up to 2.5 `least` from them. A piece of millimetres between others of metres has
// durations that no optimiser finds.
geom::Polyline without_short_legs(const geom::CollisionScene& scene, const geom::Polyline& path,
                                  double least);

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
// them, meet, to piece i: nearest first, and none for what is behind a plane already; of thousands
// only for those nearer the piece. Returns how many were added. As many segments as pieces.
std::size_t add_planes_met(const geom::CollisionScene& scene, const Trajectory& trajectory,
                           Corridor& corridor);

// Overlapping boxes of free space along the path instead, each the largest around a part of the
// path within `reach` of it (geom::empty_box), and of the chain only those that are needed: pieces
// between points that neighbouring boxes share (in general off the path), their planes the six
// faces of the box they are in. Empty for a path of one place, and where rounding leaves no room.
Corridor box_corridor(const geom::CollisionScene& scene, const geom::Polyline& path, double reach);

}  // namespace traj
