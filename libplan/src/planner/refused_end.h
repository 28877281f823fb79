#pragma once

// The answer to a query whose start or goal is not free.

#include "geom/collision/collision.h"
#include "plan/planner/plan.h"

namespace plan {

// Says why not, and where the nearest free place is, if there is one within 50 m.
PlanResult refused_end(const geom::CollisionScene& scene, const Vec3& p, bool start);

}  // namespace plan
