#pragma once

// Planners of the Open Motion Planning Library, on our exact predicate. They are a module of their
// own, which the tool loads when one of them is asked for: OMPL takes 2.5 ms to load.

#include <cstdint>
#include <functional>

#include "geom/shape/aabb.h"
#include "plan/bench/method.h"

namespace bench {

enum class OmplPlanner {
  rrt_connect,       // the first path found, then simplified
  informed_rrt_star  // the best path within the time
};

struct OmplProblem {
  geom::Aabb bounds;  // where the middle of the vehicle may be
  std::function<bool(const geom::Vec3&)> is_point_free;
  std::function<bool(const geom::Vec3&, const geom::Vec3&)> is_segment_free;
  double seconds = 1;  // for a query
  std::uint64_t seed = 0;
};

}  // namespace bench

// The module's only function. Makes one planner, cleared between queries; its random numbers run on
// from query to query, and it answers "stopped" where the time was not enough. OMPL prints nothing.
extern "C" void skyway_ompl_method(const bench::OmplProblem& problem, bench::OmplPlanner planner,
                                   plan::bench::Method& out);
