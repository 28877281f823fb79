#pragma once

// A trajectory as the few straight legs that a mission of waypoints can express.
//
// Example:
//   const geom::Polyline legs = traj::straight_legs(trajectory, 0.1);  // within 10 cm of the curve
//   const geom::Polyline clear = traj::pushed_off(scene, legs, 0.05);
//   assert(traj::check_path(scene, clear).ok);

#include "geom/collision/collision.h"
#include "geom/shape/polyline.h"
#include "traj/curve/trajectory.h"

namespace traj {

// Points on the curve, the first and the last included, such that the curve between two of them is
// within `tolerance` metres (> 0) of their leg: by control points, so between all instants. No
// point repeats its neighbour. The legs are not checked for collision here.
geom::Polyline straight_legs(const Trajectory& trajectory, double tolerance);

// The points, in the map's axes, moved away from obstacles nearer than `distance` metres, so
// that legs survive rounding: from each grown box along every axis on which a point is beside it
// (an edge's both), and from the bounds. The first and the last stay. One pass: promises nothing.
geom::Polyline pushed_off(const geom::CollisionScene& scene, geom::Polyline points,
                          double distance);

}  // namespace traj
