#include "plan/lattice/astar.h"

#include <gtest/gtest.h>

#include <bit>
#include <limits>
#include <queue>

#include "plan/lattice/build_lattice.h"
#include "support/random_city.h"

namespace plan {
namespace {

// Textbook Dijkstra over all nodes.
std::vector<double> distances(const Lattice& lattice, std::size_t source) {
  std::vector<double> cost(lattice.size(), std::numeric_limits<double>::infinity());
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  cost[source] = 0;
  open.push({0, source});
  while (!open.empty()) {
    const auto [c, n] = open.top();
    open.pop();
    if (c > cost[n]) continue;
    for (std::uint32_t m = lattice.mask(n) & ~Lattice::kNode; m; m &= m - 1) {
      const int d = std::countr_zero(m);
      const auto other = static_cast<std::size_t>(n + lattice.offset(d));
      if (c + lattice.edge_length(d) < cost[other]) {
        cost[other] = c + lattice.edge_length(d);
        open.push({cost[other], other});
      }
    }
  }
  return cost;
}

class AstarProperty : public testing::TestWithParam<Connectivity> {};

TEST_P(AstarProperty, CostsAreDijkstrasAndNoSearchDependsOnAnother) {
  const geom::CollisionScene scene(support::random_city(31, 150, 150), {"box", {1, 1, 1}}, 0);
  const Lattice lattice = build_lattice(scene, {6, GetParam(), Vec3::Zero()});
  AstarSearch search(lattice);
  support::Random random(32);
  int found = 0;
  for (int i = 0; i < 12; ++i) {
    const auto source = static_cast<std::size_t>(random.below(static_cast<int>(lattice.size())));
    if (!lattice.free(source)) continue;
    const auto expected = distances(lattice, source);
    for (int k = 0; k < 40; ++k) {
      const auto goal = static_cast<std::size_t>(random.below(static_cast<int>(lattice.size())));
      if (!lattice.free(goal)) continue;
      const Terminal from{source, 0};
      const Terminal to{goal, 0};
      const SearchResult result = search.search({&from, 1}, {&to, 1});
      ASSERT_EQ(result.found, std::isfinite(expected[goal]));
      if (!result.found) continue;
      ++found;
      ASSERT_NEAR(result.cost, expected[goal], 1e-9 * (1 + expected[goal]));
      EXPECT_EQ(result.nodes.front(), source);
      EXPECT_EQ(result.nodes.back(), goal);
      EXPECT_EQ(AstarSearch(lattice).search({&from, 1}, {&to, 1}).nodes, result.nodes);
    }
  }
  EXPECT_GT(found, 50);
}

INSTANTIATE_TEST_SUITE_P(Kinds, AstarProperty,
                         testing::Values(Connectivity::six, Connectivity::eighteen,
                                         Connectivity::twenty_six));

}  // namespace
}  // namespace plan
