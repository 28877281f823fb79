#pragma once

// Path records of planned paths.
//
// Example:
//   plan::Planner planner(scene);
//   const plan::PlanResult result = planner.plan({1, 1, 1}, {9, 1, 1});
//   std::cout << to_json_line(plan::path_record(scene, "q1", result));

#include <string>

#include "geom/collision/collision.h"
#include "geom/record/record.h"
#include "plan/planner/plan.h"

namespace plan {

// With a search report where the planner searched.
geom::PathRecord path_record(const geom::CollisionScene& scene, std::string id,
                             const PlanResult& result);

}  // namespace plan
