#pragma once

// RRT-Connect: a tree from each end (plan/sampling/rrt.h says whose).

#include <algorithm>
#include <optional>

#include "roadmap/point_index.h"
#include "sampling_search.h"

namespace plan {

class RrtConnect : SamplingSearch {
 public:
  using SamplingSearch::SamplingSearch;

  SamplingResult run() {
    index_[0].insert(from_, add_root(from_, 0));
    index_[1].insert(to_, add_root(to_, 1));
    for (std::size_t side = 0; next_iteration(); side = 1 - side) {
      const Vec3 sample = sample_bounds();
      const auto node = extend(side, index_[side].nearest(sample), sample);
      if (!node) continue;
      const auto met = connect(1 - side, point(*node));
      if (!met) continue;
      join(side == 0 ? *node : *met, side == 0 ? *met : *node);
      break;
    }
    return std::move(result_);
  }

 private:
  std::optional<std::uint32_t> extend(std::size_t side, std::uint32_t near, const Vec3& target) {
    const auto p = step_towards(near, target);
    if (!p) return std::nullopt;
    const std::uint32_t node = add_child(*p, near);
    index_[side].insert(*p, node);
    return node;
  }

  // The node of that tree that stands on `target`, if it could be grown there. The newest node is
  // always the nearest.
  std::optional<std::uint32_t> connect(std::size_t side, const Vec3& target) {
    std::uint32_t node = index_[side].nearest(target);
    while (point(node) != target) {
      if (!next_iteration()) return std::nullopt;
      const auto grown = extend(side, node, target);
      if (!grown) return std::nullopt;
      node = *grown;
    }
    return node;
  }

  void join(std::uint32_t of_start, std::uint32_t of_goal) {
    found_first(result_.tree.cost[of_start] + result_.tree.cost[of_goal]);
    result_.path = path_to_root(of_start);
    std::reverse(result_.path.begin(), result_.path.end());
    const geom::Polyline rest = path_to_root(of_goal);
    result_.path.insert(result_.path.end(), rest.begin() + 1, rest.end());
  }

  PointIndex index_[2];
};

}  // namespace plan
