#pragma once

// The ends of a query that were moved to free places, in words for the user.
//
// Example:
//   const geom::PlanQuery query{.id = "q1", .from = {4.2, 4, 4}, .to = {9, 1, 1}};
//   plan::Planner planner(scene);
//   const plan::PlanResult result = planner.plan(query.from, query.to, {.snap_ends = 2});
//   for (const std::string& said : plan::moved_ends(scene, query, result)) std::cout << said <<
//   '\n';

#include <string>
#include <vector>

#include "geom/collision/collision.h"
#include "geom/record/query_record.h"
#include "plan/planner/plan.h"

namespace plan {

// A sentence for each end that was moved: why, how far and where to, and whether there is little
// room. Empty if none was. The result is that of the query.
std::vector<std::string> moved_ends(const geom::CollisionScene& scene, const geom::PlanQuery& query,
                                    const PlanResult& result);

}  // namespace plan
