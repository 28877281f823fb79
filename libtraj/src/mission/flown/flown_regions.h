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
  // Holds the arc from an angle on, so wide (clockwise where that is below 0): its ends, and
  // corners of tangents to it.
  Hull arc(double from, double wide) const;
  Hull disc() const;  // holds all of it
};

// Around a circle from its point nearest to where the vehicle comes from, and on from there.
struct CircleFlight {
  Hull entry;                // all ways in
  std::vector<Hull> arcs;    // hold all of the circle
  std::vector<Vec3> points;  // of it, the first again at the end
  Hull leaving;              // where it may be when it goes on
};

// `from`: where it may be before, the last point the one that the mission says; no nearer to the
// centre than half the radius. Rounding of places moves the nearest point along the circle by up to
// twice as much: there is room for 5 cm.
CircleFlight fly_circle(const Circle& circle, const Hull& from);

// A return from anywhere in `low`: up to the height of `above`, across, and no further. Nearer to
// `above` than the cone is at its height, some autopilots return lower (PX4's cone of 45 degrees,
// ArduCopter's), so all heights between are held too. `slope`: height over distance of such a cone;
// 0: none of them has one.
std::vector<Hull> return_hulls(const Hull& low, const Vec3& above, double ground, double slope);

}  // namespace traj
