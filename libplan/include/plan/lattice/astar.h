#pragma once

// A* on a lattice.
//
// Example:
//   const plan::Lattice lattice = plan::build_lattice(scene, {.spacing = 1});
//   plan::AstarSearch search(lattice);
//   const plan::Terminal start{*lattice.node({0, 0, 0})};
//   const plan::Terminal goal{lattice.size() - 1};
//   const plan::SearchResult found = search.search({{start}}, {{goal}});
//   assert(found.found && found.nodes.front() == start.node);

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "plan/lattice/lattice.h"

namespace plan {

struct Terminal {  // a node where a search may begin or end, and what getting there costs, metres
  std::size_t node = 0;
  double cost = 0;
};

struct SearchResult {
  bool found = false;
  bool gave_up = false;            // there may be a path all the same: too many nodes to look at
  std::vector<std::size_t> nodes;  // from a source to a goal; empty unless found
  double cost = 0;                 // metres, the costs of both terminals included
  std::size_t expanded = 0;
};

// Shortest paths from any source to any goal. Lengths are counted in whole units of 2^-36 spacings,
// so sums are exact, ties are ties, and a path is shortest up to 1e-11 of its length. The heuristic
// is the distance to the goals on the unobstructed lattice of this connectivity, or to the box
// around them where they are many (both consistent); ties go to the larger cost so far, then to the
// lowest block, then the lowest node in it. With a `weight` of that distance above 1, at most 2
// and rounded to 1/1024, a path costs at most that times the least, and far fewer nodes are looked
// at where many ways are about as short (weighted A*, Pohl 1970). A search that takes long floods
// the lattice from the goals too, so that goals in a pocket are known to be out of reach once the
// pocket was searched. Terminals must be free nodes, their costs non-negative and below 2^20
// spacings. Blocks of the lattice are read when first met and kept, with 20 bytes a node, up to 170
// MB between searches; one that meets more than 16,384 new blocks (8 M nodes) gives up. No search
// depends on an earlier one. The lattice must outlive it; one thread at a time.
class AstarSearch {
 public:
  explicit AstarSearch(const Lattice& lattice);
  ~AstarSearch();
  AstarSearch(AstarSearch&&) noexcept;
  AstarSearch& operator=(AstarSearch&&) noexcept;

  // Throws geom::InputError for a weight that is not from 1 to 2.
  SearchResult search(std::span<const Terminal> sources, std::span<const Terminal> goals,
                      double weight = 1);

  bool free(const Index3& node);  // as Lattice::free of one inside it, by the blocks kept here

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace plan
