#pragma once

// RRT* and Informed RRT* (plan/sampling/rrt.h says whose).

#include "plan/sampling/rrt.h"

namespace plan {

// As sample_path(), whose checks are done: both ends are free.
SamplingResult grow_rrt_star(const geom::CollisionScene& scene, const Vec3& from, const Vec3& to,
                             const SamplingOptions& options, bool informed);

}  // namespace plan
