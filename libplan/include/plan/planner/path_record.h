#pragma once

// Path records of planned paths.

#include <string>

#include "geom/collision/collision.h"
#include "geom/record/record.h"
#include "plan/planner/plan.h"

namespace plan {

// With a search report where the planner searched.
geom::PathRecord path_record(const geom::CollisionScene& scene, std::string id,
                             const PlanResult& result);

}  // namespace plan
