#pragma once

// Regions that a multirotor may fly through anywhere beside straight legs, as points of their
// hulls.

#include <vector>

#include "traj/curve/trajectory.h"

namespace traj {

using Hull = std::vector<Vec3>;

// What is left of the leg from `from` to `corner` when a turn begins, `radius` metres before the
// corner: no further back than the leg.
Vec3 before_corner(const Vec3& from, const Vec3& corner, double radius);

// The corner's triangle within `radius`, and so many metres of the first leg beyond the corner.
Hull corner_hull(const Vec3& from, const Vec3& corner, const Vec3& to, double radius,
                 double beyond);

// ArduPilot's spline from a to b (libraries/AP_Math/SplineCurve): a cubic with end velocities that
// are scaled down together until their lengths sum to no more than four times the leg. Which
// velocity it has depends on what is before and after, so all of `leaving` and `arriving` are
// allowed for, and rest: its Bezier points are within these.
Hull spline_hull(const Vec3& a, const Vec3& b, const std::vector<Vec3>& leaving,
                 const std::vector<Vec3>& arriving);

// A level circle. Angles in radians, counterclockwise from x.
struct Circle {
  Vec3 centre;
  double radius = 0;

  Vec3 at(double angle) const;
  double angle_to(const Vec3& p) const;
  // Holds the arc between two angles, the shorter way: its ends, and corners of tangents to it.
  Hull arc(double from, double to) const;
  Hull disc() const;  // holds all of it
};

}  // namespace traj
