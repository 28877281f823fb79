#pragma once

// Slow and obviously right: Dijkstra without a queue's cleverness, on a lattice's masks.

#include <limits>
#include <queue>
#include <span>
#include <vector>

#include "plan/lattice/astar.h"
#include "plan/lattice/lattice.h"

namespace oracle {

// The cost of the cheapest path from any source to any goal; infinity when there is none.
inline double cheapest(const plan::Lattice& lattice, std::span<const plan::Terminal> sources,
                       std::span<const plan::Terminal> goals) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  using Entry = std::pair<double, std::size_t>;
  std::vector<double> cost(lattice.size(), kFar);
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  for (const plan::Terminal& source : sources) {
    cost[source.node] = std::min(cost[source.node], source.cost);
    open.push({source.cost, source.node});
  }
  while (!open.empty()) {
    const auto [so_far, node] = open.top();
    open.pop();
    if (so_far > cost[node]) continue;
    for (int d = 0; d < plan::kDirections; ++d) {
      if (!(lattice.mask(node) >> d & 1)) continue;
      plan::Index3 to = lattice.index(node);
      for (int k = 0; k < 3; ++k) to[k] += plan::kDirection[d][k];
      const std::size_t next = lattice.node(to).value();
      const double through = so_far + (lattice.position(next) - lattice.position(node)).norm();
      if (through < cost[next]) {
        cost[next] = through;
        open.push({through, next});
      }
    }
  }
  double best = kFar;
  for (const plan::Terminal& goal : goals) best = std::min(best, cost[goal.node] + goal.cost);
  return best;
}

}  // namespace oracle
