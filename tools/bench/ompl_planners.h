#pragma once

// Planners of the Open Motion Planning Library, on our scene and its exact predicate.

#include <cstdint>
#include <memory>

#include "plan/bench/trial.h"

namespace bench {

enum class OmplPlanner {
  rrt_connect,       // the first path found, then simplified
  informed_rrt_star  // the best path within the time
};

// One planner, cleared between queries; its random numbers run on from query to query. The scene
// must outlive it. OMPL prints nothing.
class OmplAdapter {
 public:
  OmplAdapter(const geom::CollisionScene& scene, OmplPlanner planner, double seconds,
              std::uint64_t seed);
  ~OmplAdapter();

  plan::bench::Answer plan(
      const geom::PlanQuery& query);  // "stopped" where the time was not enough

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace bench
