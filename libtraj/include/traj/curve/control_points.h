#pragma once

// The control points of a whole trajectory, in order.
//
// Example:
//   const std::vector<geom::Vec3> points = traj::control_points(trajectory);
//   assert(points.size() == trajectory.segments.size() * traj::kPoints);

#include <vector>

#include "traj/curve/trajectory.h"

namespace traj {

// The curve lies in their convex hull. Empty where there is no segment.
inline std::vector<Vec3> control_points(const Trajectory& trajectory) {
  std::vector<Vec3> out;
  for (const Segment& s : trajectory.segments) {
    out.insert(out.end(), s.point.begin(), s.point.end());
  }
  return out;
}

}  // namespace traj
