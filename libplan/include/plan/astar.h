#pragma once

// A* on a lattice.

#include <cstdint>
#include <span>
#include <vector>

#include "plan/lattice.h"

namespace plan {

struct Terminal {  // a node where a search may begin or end, and what getting there costs, metres
  std::size_t node = 0;
  double cost = 0;
};

struct SearchResult {
  bool found = false;
  std::vector<std::size_t> nodes;  // from a source to a goal; empty unless found
  double cost = 0;                 // metres, the costs of both terminals included
  std::size_t expanded = 0;
};

// Shortest paths from any source to any goal, exact up to the rounding of sums of edge lengths. The
// workspace is kept between searches and no search depends on an earlier one. The heuristic is the
// distance on the unobstructed lattice of this connectivity (consistent); ties go to the larger
// cost so far, then to the lowest node. The lattice must outlive the search.
class AstarSearch {
 public:
  explicit AstarSearch(const Lattice& lattice);

  SearchResult search(std::span<const Terminal> sources, std::span<const Terminal> goals);

 private:
  struct Visit {
    double cost = 0;
    std::uint32_t stamp = 0;
    std::int8_t arrived_by = -1;  // direction of the last edge; -1 at a source
    bool settled = false;
  };
  struct Open {
    double bound;
    double cost;
    std::uint32_t node;
  };

  static bool comes_later(const Open& a, const Open& b);
  double to_goal(std::size_t node) const;
  void push(std::size_t node, double cost, int direction);
  std::vector<std::size_t> trace(std::size_t node) const;

  const Lattice* lattice_;
  std::vector<Visit> visits_;
  std::vector<Open> open_;
  std::vector<Terminal> goals_;
  std::vector<Index3> goal_index_;
  std::uint32_t stamp_ = 0;
};

}  // namespace plan
