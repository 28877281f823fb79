#pragma once

// Paths of an older map on a newer one: free legs are kept, blocked ones mended.
//
// Example:
//   plan::Planner planner(scene);  // of the newer map
//   const plan::ReplanResult result = plan::replan(scene, planner, path);
//   assert(result.origin.mended.empty());  // every leg is still free

#include "geom/collision/collision.h"
#include "geom/record/record.h"
#include "plan/planner/plan.h"

namespace plan {

struct ReplanResult {
  // The path, every leg free. Its report sums up the mends: `expanded` is their sum, route and
  // resolution are those of the mend that expanded most; steps are "splice" and "taut". A path kept
  // whole has no route; one planned anew has the report of that plan.
  PlanResult plan;
  geom::PathOrigin origin;  // both empty unless found
};

// `path`, of at least one point, on the planner's map. Legs that are free (exact) are kept bit for
// bit. Each run of blocked legs is planned anew between its ends, and the mend pulled taut together
// with 1, 2, 4 … kept legs on either side, as long as it is more than 0.5 % longer than the old
// stretch and pulling gains more than 0.5 %. Where a run finds no way between its ends, or the
// outcome is more than 5 % longer than `path`, the whole is planned anew: that is taken where there
// is no mended path or it is more than 5 % longer than the new one. A path all of whose legs are
// free costs only their checks. Status and message are those of the planner where there
// is no path. Threads may share the planner.
ReplanResult replan(const geom::CollisionScene& scene, Planner& planner, const geom::Polyline& path,
                    Quality quality = Quality::normal);

}  // namespace plan
