#pragma once

// RRT: one tree from the start (plan/sampling/rrt.h says whose).

#include <algorithm>

#include "roadmap/point_index.h"
#include "sampling_search.h"

namespace plan {

class Rrt : SamplingSearch {
 public:
  using SamplingSearch::SamplingSearch;

  SamplingResult run() {
    index_.insert(from_, add_root(from_, 0));
    while (next_iteration()) {
      const Vec3 sample = sample_bounds_or_goal();
      const std::uint32_t near = index_.nearest(sample);
      const auto p = step_towards(near, sample);
      if (!p) continue;
      std::uint32_t node = add_child(*p, near);
      index_.insert(*p, node);
      if (*p != to_) {
        if (!sees_goal_within_step(node)) continue;
        node = add_child(to_, node);
      }
      found_first(result_.tree.cost[node]);
      result_.path = path_to_root(node);
      std::reverse(result_.path.begin(), result_.path.end());
      break;
    }
    return std::move(result_);
  }

 private:
  PointIndex index_;
};

}  // namespace plan
