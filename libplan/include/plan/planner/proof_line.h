#pragma once

// The proof that a planner's answer carries, as a line of a file of certificates.
//
// Example:
//   const geom::PlanQuery query{.id = "q1", .from = {1, 1, 1}, .to = {9, 1, 1}};
//   plan::Planner planner(scene);
//   const plan::PlanResult result = planner.plan(query.from, query.to);
//   std::cout << plan::proof_line(scene, query, result);  // nothing was asked to be proved

#include <string>

#include "geom/collision/collision.h"
#include "geom/record/query_record.h"
#include "plan/planner/plan.h"

namespace plan {

// The enclosure that shows that there is no path, or the proof of the bound on its length; it ends
// with a newline. Empty where the result has neither. docs/certificates.md says what is in it.
std::string proof_line(const geom::CollisionScene& scene, const geom::PlanQuery& query,
                       PlanResult result);

}  // namespace plan
