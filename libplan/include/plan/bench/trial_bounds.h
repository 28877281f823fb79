#pragma once

// How short the paths of the queries can be at all, whoever plans them.
//
// No example: it completes the runs of plan/bench/measure.h.

#include <vector>

#include "geom/base/execution.h"
#include "plan/bench/query_set.h"
#include "plan/bench/trial.h"

namespace plan::bench {

// Sets Trial::bound of every path that was found: one lower bound a query, wanted within `gap` of
// the shortest path that any of the runs found (plan/bound/bound.h). Throws std::logic_error where
// a bound is above a path: then one of the two proofs is wrong.
void add_bounds(std::vector<Run>& runs, const geom::CollisionScene& scene, QuerySet& queries,
                double gap, const geom::Execution& run);

}  // namespace plan::bench
