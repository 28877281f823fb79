#pragma once

// Regions that a vehicle may fly through anywhere, held against a map and fences.
//
// Example:
//   const traj::Sweep corner{.hull = {{1, 1, 1}, {2, 1, 1}, {1, 2, 1}}};
//   traj::CheckResult result;
//   traj::check_sweeps(scene, {{corner}}, geom::Vec3::Zero(), result);
//   assert(result.reason == traj::Reason::none);

#include <span>

#include "geom/collision/collision.h"
#include "traj/mission/flown/fence.h"
#include "traj/mission/flown/sweep.h"
#include "traj/proof/check.h"

namespace traj {

// Holds all sweeps, and everything within `stray` of them along each axis, against bounds and
// obstacles, by planes that separate (geom::hull_meets): nothing is sampled. Of those that are
// refused, that which is furthest out of the bounds, else the deepest. `result` gets reason, part,
// place, depth and box, unless it has a reason already.
void check_sweeps(const geom::CollisionScene& scene, std::span<const Sweep> sweeps,
                  const Vec3& stray, CheckResult& result);

// Holds the places of each drift against bounds and obstacles, for the vehicle without its margin
// but `navigation` metres larger on every side: the margin is what an autopilot may stray. `result`
// as above, and `strayed`.
void check_drift(const geom::CollisionScene& scene, std::span<const Drift> drift, const Vec3& stray,
                 const Vec3& navigation, CheckResult& result);

// The sweeps against fences, in plan: the whole vehicle with its margin stays in every inclusion
// and out of every exclusion. `worst` is how far beyond the first fence that it does not keep to
// one of the points is.
void check_fences(const geom::CollisionScene& scene, std::span<const Sweep> sweeps,
                  std::span<const Fence> fences, const Vec3& stray, CheckResult& result);

// The same of where autopilots may be, for the vehicle as in check_drift.
void check_fences(const geom::CollisionScene& scene, std::span<const Drift> drift,
                  std::span<const Fence> fences, const Vec3& stray, const Vec3& navigation,
                  CheckResult& result);

}  // namespace traj
