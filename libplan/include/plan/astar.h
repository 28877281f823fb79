#pragma once

// A* on a lattice.

#include <array>
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

// Shortest paths from any source to any goal. Lengths are counted in whole units of 2^-36 spacings,
// so sums are exact, ties are ties, and a path is shortest up to 1e-11 of its length. The heuristic
// is the distance to the goals on the unobstructed lattice of this connectivity, or to the box
// around them where they are many (both consistent); ties go to the larger cost so far, then to the
// lowest node. Terminals must be free nodes, their costs non-negative and below 2^20 spacings. The
// workspace (16 bytes a node) is kept between searches, and no search depends on an earlier one.
// The lattice must outlive it; one thread at a time.
class AstarSearch {
 public:
  explicit AstarSearch(const Lattice& lattice);

  SearchResult search(std::span<const Terminal> sources, std::span<const Terminal> goals);

 private:
  using Units = std::uint64_t;

  struct Visit {
    Units cost = 0;
    std::uint32_t stamp = 0;
    std::int8_t arrived_by = -1;  // direction of the last edge; -1 at a source
    bool settled = false;
  };
  struct Open {
    Units bound;
    Units cost;
    std::uint32_t node;
  };
  struct Goal {
    std::int32_t x, y, z;
    std::uint32_t node;
    Units cost;
    double metres;
  };

  static bool earlier(const Open& a, const Open& b);
  void start(std::span<const Terminal> sources, std::span<const Terminal> goals);
  void expand(const Open& from);
  void push(std::uint32_t node, Units cost, int direction, std::int32_t x, std::int32_t y,
            std::int32_t z);
  void insert(const Open& entry);
  void push_heap(const Open& entry);
  Open take_first();
  Units to_goal(std::int32_t x, std::int32_t y, std::int32_t z) const;
  Units to_box(std::int32_t x, std::int32_t y, std::int32_t z) const;
  const Goal* goal_at(std::uint32_t node) const;
  Units units(double metres) const;
  std::vector<std::size_t> trace(std::size_t node) const;
  double metres(std::span<const std::size_t> nodes) const;

  const Lattice* lattice_;
  std::vector<Visit> visits_;
  std::vector<Open> open_;  // a heap of four children a node: shallower, and fewer cache misses
  Open next_{};             // earlier than all of the heap, where there is one
  bool has_next_ = false;
  std::vector<Goal> goals_;  // by node, the cheapest of each
  Goal lowest_{};            // the box around the goals, and the least cost of any
  Goal highest_{};
  std::array<Units, kDirections> step_;
  std::uint32_t stamp_ = 0;
};

}  // namespace plan
