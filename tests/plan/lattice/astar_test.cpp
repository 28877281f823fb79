#include "plan/lattice/astar.h"

#include <gtest/gtest.h>

#include <limits>

#include "geom/base/error.h"
#include "plan/lattice/build_lattice.h"
#include "plan/scenes.h"
#include "support/dijkstra.h"
#include "support/random_city.h"

namespace plan {
namespace {

// The cost of a returned path, summed anew; checks each edge on the way.
double cost_of(const Lattice& lattice, const SearchResult& result,
               std::span<const Terminal> sources, std::span<const Terminal> goals) {
  const auto end = [](std::span<const Terminal> list, std::size_t node) {
    double best = std::numeric_limits<double>::infinity();
    for (const Terminal& t : list) best = t.node == node ? std::min(best, t.cost) : best;
    return best;
  };
  double sum = end(sources, result.nodes.front()) + end(goals, result.nodes.back());
  for (std::size_t i = 1; i < result.nodes.size(); ++i) {
    bool joined = false;
    for (int d = 0; d < kDirections; ++d) {
      joined = joined || ((lattice.mask(result.nodes[i - 1]) >> d & 1) &&
                          static_cast<std::int64_t>(result.nodes[i - 1]) + lattice.offset(d) ==
                              static_cast<std::int64_t>(result.nodes[i]));
    }
    EXPECT_TRUE(joined);
    sum += (lattice.position(result.nodes[i]) - lattice.position(result.nodes[i - 1])).norm();
  }
  return sum;
}

std::vector<Terminal> random_terminals(support::Random& random, const Lattice& lattice, int count) {
  std::vector<Terminal> list;
  while (static_cast<int>(list.size()) < count) {
    const auto node = static_cast<std::size_t>(random.below(static_cast<int>(lattice.size())));
    if (lattice.free(node)) list.push_back({node, random.uniform(0, 3)});
  }
  return list;
}

class Astar : public testing::TestWithParam<Connectivity> {
 protected:
  // From up to three nodes of random lattices to up to three or to 40: ask(…) finds a way where
  // there is one, of the cost that it says. Calls f for each that was found.
  template <class Search, class F>
  static void ask_many(const Search& ask, const F& f) {
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
      SCOPED_TRACE(seed);
      const auto scene = random_scene(seed, 250, 14, Vec3::Zero());
      const Lattice lattice = build_lattice(scene, {1, GetParam(), {0, 0, 0}});
      AstarSearch search(lattice);
      support::Random random(seed);
      for (int query = 0; query < 12; ++query) {
        const auto sources = random_terminals(random, lattice, 1 + query % 3);
        const auto goals = random_terminals(random, lattice, query % 4 ? query % 4 : 40);
        const double least = oracle::cheapest(lattice, sources, goals);
        const SearchResult result = ask(search, sources, goals);
        ASSERT_EQ(result.found, least < 1e300);
        if (!result.found) continue;
        EXPECT_NEAR(cost_of(lattice, result, sources, goals), result.cost, 1e-9);
        f(result, least, search, sources, goals);
      }
    }
  }
};

TEST_P(Astar, CostsWhatDijkstraSaysFromManySourcesToManyGoals) {
  ask_many(
      [](AstarSearch& search, const auto& from, const auto& to) { return search.search(from, to); },
      [](const SearchResult& result, double least, auto&&...) {
        EXPECT_NEAR(result.cost, least, 1e-9);
      });
}

TEST_P(Astar, CostsNoMoreThanItsWeightTimesTheLeast) {
  const double weight = 1.25;
  std::size_t longer = 0;
  std::size_t expanded = 0;
  std::size_t expanded_without = 0;
  ask_many([&](AstarSearch& search, const auto& from,
               const auto& to) { return search.search(from, to, weight); },
           [&](const SearchResult& result, double least, AstarSearch& search, const auto& from,
               const auto& to) {
             EXPECT_LE(result.cost, weight * least + 1e-9);
             longer += result.cost > least + 1e-6;
             expanded += result.expanded;
             expanded_without += search.search(from, to).expanded;
           });
  EXPECT_GT(longer, 0u);  // the weight was heard
  EXPECT_LT(expanded, expanded_without);
}

TEST_P(Astar, RefusesAWeightThatIsNone) {
  const auto scene = scene_of({}, {{0, 0, 0}, {3, 3, 3}});
  const Lattice lattice = build_lattice(scene, {1, GetParam(), {0, 0, 0}});
  AstarSearch search(lattice);
  const Terminal end[] = {{7, 0}};
  for (const double weight : {0.999, 2.001, std::numeric_limits<double>::infinity(),
                              std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(search.search(end, end, weight), geom::InputError) << weight;
  }
}

TEST_P(Astar, WithoutObstaclesExpandsLittleMoreThanThePath) {
  const auto scene = scene_of({}, {{0, 0, 0}, {30, 30, 30}});
  const Lattice lattice = build_lattice(scene, {1, GetParam(), {0, 0, 0}});
  AstarSearch search(lattice);
  const Terminal from[] = {{lattice.node({2, 3, 4}).value(), 0}};
  const Terminal to[] = {{lattice.node({28, 20, 9}).value(), 0}};
  const SearchResult result = search.search(from, to);
  ASSERT_TRUE(result.found);
  EXPECT_LE(result.expanded, result.nodes.size());
}

TEST_P(Astar, AnswersDoNotDependOnEarlierSearches) {
  const auto scene = random_scene(5, 200, 14, Vec3::Zero());
  const Lattice lattice = build_lattice(scene, {1, GetParam(), {0, 0, 0}});
  AstarSearch used(lattice);
  support::Random random(1);
  for (int query = 0; query < 40; ++query) {
    const auto sources = random_terminals(random, lattice, 2);
    const auto goals = random_terminals(random, lattice, 2);
    AstarSearch fresh(lattice);
    const SearchResult a = used.search(sources, goals);
    const SearchResult b = fresh.search(sources, goals);
    EXPECT_EQ(a.nodes, b.nodes);
    EXPECT_EQ(a.cost, b.cost);
    EXPECT_EQ(a.expanded, b.expanded);
  }
}

INSTANTIATE_TEST_SUITE_P(EachConnectivity, Astar,
                         testing::Values(Connectivity::six, Connectivity::eighteen,
                                         Connectivity::twenty_six),
                         [](const auto& kind) {
                           return std::to_string(static_cast<int>(kind.param));
                         });

TEST(AstarEnds, AreOneNodeWhenASourceIsAGoal) {
  const auto scene = scene_of({}, {{0, 0, 0}, {3, 3, 3}});
  const Lattice lattice = build_lattice(scene, {1, Connectivity::six, {0, 0, 0}});
  AstarSearch search(lattice);
  const Terminal end[] = {{7, 0.5}};
  const SearchResult result = search.search(end, end);
  EXPECT_TRUE(result.found);
  EXPECT_EQ(result.nodes, std::vector<std::size_t>{7});
  EXPECT_EQ(result.cost, 1.0);
}

TEST(AstarEnds, GiveNoPathWhereThereAreNone) {
  const auto scene = scene_of({}, {{0, 0, 0}, {3, 3, 3}});
  const Lattice lattice = build_lattice(scene, {1, Connectivity::six, {0, 0, 0}});
  AstarSearch search(lattice);
  const Terminal end[] = {{7, 0}};
  EXPECT_FALSE(search.search({}, end).found);
  EXPECT_FALSE(search.search(end, {}).found);
}

TEST(AstarEnds, AreNotFoundAcrossAWall) {
  const auto scene = scene_of({{{4.5, -1, -1}, {4.6, 11, 11}}}, {{0, 0, 0}, {10, 10, 10}});
  const Lattice lattice = build_lattice(scene, {1, Connectivity::twenty_six, {0, 0, 0}});
  AstarSearch search(lattice);
  const Terminal from[] = {{lattice.node({0, 0, 0}).value(), 0}};
  const Terminal to[] = {{lattice.node({10, 0, 0}).value(), 0}};
  const SearchResult result = search.search(from, to);
  EXPECT_FALSE(result.found);
  EXPECT_TRUE(result.nodes.empty());
  EXPECT_EQ(result.expanded, 5 * 11 * 11u);
}

}  // namespace
}  // namespace plan
