#pragma once

// Derivatives, halves and snap of a segment, on its Bernstein control points.

#include <array>
#include <utility>

#include "traj/curve/trajectory.h"

namespace traj {

// Control points of the derivatives in time, of degree 6, 5 and 4: m/s, m/s2, m/s3. The curve of
// each lies in the convex hull of its points. Rounded: a few ulp of the largest point, over the
// duration to the power of the derivative.
std::array<Vec3, 7> velocity_points(const Segment& segment);
std::array<Vec3, 6> acceleration_points(const Segment& segment);
std::array<Vec3, 5> jerk_points(const Segment& segment);

// The first and the second half (de Casteljau at one half), yaw included. They share the middle
// point bit for bit.
std::pair<Segment, Segment> split(const Segment& segment);

// The integral of |fourth derivative|^2 over the segment, in m2/s7.
double snap_cost(const Segment& segment);
double snap_cost(const Trajectory& trajectory);

}  // namespace traj
