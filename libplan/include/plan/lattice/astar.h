#pragma once

// A* on a lattice.

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <unordered_map>
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
// lowest block, then the lowest node in it. A search that takes long floods the lattice from the
// goals too, so that goals in a pocket are known to be out of reach once the pocket was searched.
// Terminals must be free nodes, their costs non-negative and below 2^20 spacings. Blocks of the
// lattice are read when first met and kept, with 20 bytes a node, up to 170 MB between searches;
// one that meets more than 16,384 new blocks (8 M nodes) gives up. No search depends on an earlier
// one. The lattice must outlive it; one thread at a time.
class AstarSearch {
 public:
  explicit AstarSearch(const Lattice& lattice);
  ~AstarSearch();
  AstarSearch(AstarSearch&&) noexcept;
  AstarSearch& operator=(AstarSearch&&) noexcept;

  SearchResult search(std::span<const Terminal> sources, std::span<const Terminal> goals);

  bool free(const Index3& node);  // as Lattice::free of one inside it, by the blocks kept here

 private:
  using Units = std::uint64_t;
  // A node: its block, its place in the block, and the page that holds the block. In that order
  // from the highest bits, so that comparing handles compares nodes.
  using Handle = std::uint64_t;

  struct Visit {
    Units cost = 0;
    std::uint32_t stamp = 0;
    std::int8_t arrived_by = -1;  // direction of the last edge; -1 at a source
    bool settled = false;
  };
  struct Open {
    Units bound;
    Units cost;
    Handle node;
  };
  struct Goal {
    std::int32_t x, y, z;
    Handle node;
    Units cost;
    double metres;
  };
  struct Page;
  struct Place {  // of a node on its page
    std::int32_t x, y, z;
  };

  static bool earlier(const Open& a, const Open& b);
  Page& page_of(Handle node);
  Handle handle(const Index3& node);
  Handle neighbour(Handle from, Page& page, const Place& place, int direction);
  std::uint32_t page_at(std::uint64_t block);
  void start(std::span<const Terminal> sources, std::span<const Terminal> goals);
  void expand(const Open& from);
  void push(Handle node, Units cost, int direction, std::int32_t x, std::int32_t y, std::int32_t z);
  void insert(const Open& entry);
  void add(const Open& entry);
  Open take_first();
  void flood(Handle node);
  void flood_next();
  bool goals_cut_off() const { return flooding_ && flood_next_ == flooded_.size(); }
  Units to_goal(std::int32_t x, std::int32_t y, std::int32_t z) const;
  Units to_box(std::int32_t x, std::int32_t y, std::int32_t z) const;
  const Goal* goal_at(Handle node) const;
  Units units(double metres) const;
  std::vector<std::size_t> trace(Handle node);
  double metres(std::span<const std::size_t> nodes) const;

  const Lattice* lattice_;
  Index3 blocks_;
  std::vector<std::unique_ptr<Page>> pages_;
  std::unordered_map<std::uint64_t, std::uint32_t> page_of_block_;
  std::vector<Open> open_;  // a heap
  Open next_{};             // earlier than all of the heap, where there is one
  bool has_next_ = false;
  std::vector<Goal> goals_;  // by node, the cheapest of each
  Goal lowest_{};            // the box around the goals, and the least cost of any
  Goal highest_{};
  std::array<Units, kDirections> step_;
  std::uint32_t stamp_ = 0;
  std::vector<Handle> flooded_;  // from the goals, in the order met
  std::size_t flood_next_ = 0;
  bool flooding_ = false;  // until the flood meets the search
};

}  // namespace plan
