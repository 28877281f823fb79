#pragma once

// How near a curve comes to the obstacles on its way.
//
// Example:
//   const auto profile = traj::clearance_profile(scene, trajectory, 0.5);  // each half second
//   assert(!profile.empty() && profile[0].clearance > 0);

#include <span>
#include <vector>

#include "geom/collision/collision.h"
#include "traj/curve/trajectory.h"

namespace traj {

// The least distance in a part of the way, metres to the obstacles grown by the vehicle without its
// margin, to 1 mm.
struct ClearanceSpan {
  double begin = 0;  // seconds, or metres along a path
  double end = 0;
  double clearance = 0;
};

// The parts lie side by side, each segment or leg in the fewest equal ones of at most `step` (> 0).
// Empty on a map without obstacles. By branch and bound over control points, never by samples.
std::vector<ClearanceSpan> clearance_profile(const geom::CollisionScene& scene,
                                             const Trajectory& trajectory, double step);
std::vector<ClearanceSpan> clearance_profile(const geom::CollisionScene& scene,
                                             std::span<const Vec3> path, double step);

// A part a leg of `path`, whose points are reached at these `times` (one each, ascending).
std::vector<ClearanceSpan> clearance_profile(const geom::CollisionScene& scene,
                                             std::span<const Vec3> path,
                                             std::span<const double> times);

}  // namespace traj
