#pragma once

// The blocks of a lattice that searches came to, and what they wrote there.

#include <array>
#include <bitset>
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "plan/lattice/lattice.h"

namespace plan {

// What a search knows of a node.
struct NodeVisit {
  std::uint64_t cost = 0;
  std::uint32_t stamp = 0;
  std::int8_t arrived_by = -1;  // direction of the last edge; -1 at a source
  bool settled = false;
};

// A node: its block, its place in the block, and the page that holds the block. In that order from
// the highest bits, so that comparing handles compares nodes.
using NodeHandle = std::uint64_t;

// Pages are read when first met and kept. `lattice` must outlive it; one thread at a time.
class SearchPages {
 public:
  struct Place {  // of a node on its page
    std::int32_t x, y, z;
  };
  // A block of the lattice and what searches wrote there.
  struct Page {
    Lattice::Block masks;
    std::array<NodeVisit, LatticeGrid::kBlock> visits{};
    std::uint64_t block = 0;
    Place low{};
    std::array<std::uint32_t, 27> near;  // pages around it, x fastest
    std::uint32_t flood_stamp = 0;
    std::bitset<LatticeGrid::kBlock> flooded;
  };

  explicit SearchPages(const Lattice& lattice)
      : lattice_(&lattice), blocks_(lattice.grid().blocks()) {}

  std::size_t size() const { return pages_.size(); }
  void clear();

  NodeHandle handle(const Index3& node);
  Page& page_of(NodeHandle node) { return *pages_[node & kPageMask]; }
  static std::size_t local(NodeHandle node) {
    return node >> kPageBits & (LatticeGrid::kBlock - 1);
  }
  static Place place_of(NodeHandle node);
  NodeVisit& visit(NodeHandle node) { return page_of(node).visits[local(node)]; }
  // The directions of its edges, as bits.
  std::uint32_t edges(NodeHandle node) {
    return page_of(node).masks[local(node)] & ~Lattice::kNode;
  }

  // The node that an edge leads to: so it is inside the lattice.
  NodeHandle neighbour(NodeHandle from, Page& page, const Place& place, int direction);

 private:
  static constexpr int kPageBits = 22;  // of a handle
  static constexpr std::uint64_t kPageMask = (1u << kPageBits) - 1;
  static constexpr std::uint32_t kUnknown = 0xffffffff;

  std::uint32_t page_at(std::uint64_t block);

  const Lattice* lattice_;
  Index3 blocks_;
  std::vector<std::unique_ptr<Page>> pages_;
  std::unordered_map<std::uint64_t, std::uint32_t> page_of_block_;
};

inline SearchPages::Place SearchPages::place_of(NodeHandle node) {
  const auto at = static_cast<std::int32_t>(local(node));
  return {at & 7, at >> 3 & 7, at >> 6};
}

inline NodeHandle SearchPages::neighbour(NodeHandle from, Page& page, const Place& place,
                                         int direction) {
  const auto& [dx, dy, dz] = kDirection[static_cast<std::size_t>(direction)];
  const int x = place.x + dx;
  const int y = place.y + dy;
  const int z = place.z + dz;
  constexpr int kSide = LatticeGrid::kSide;
  if (((x | y | z) & ~(kSide - 1)) == 0) {
    const std::int64_t by = dx + kSide * (dy + kSide * dz);
    return from + (static_cast<NodeHandle>(by) << kPageBits);
  }
  const int sx = x >> 3;  // -1, 0 or 1
  const int sy = y >> 3;
  const int sz = z >> 3;
  std::uint32_t& near = page.near[static_cast<std::size_t>(sx + 1 + 3 * (sy + 1 + 3 * (sz + 1)))];
  if (near == kUnknown) {
    near = page_at(static_cast<std::uint64_t>(static_cast<std::int64_t>(page.block) + sx +
                                              blocks_[0] * (sy + blocks_[1] * sz)));
  }
  const auto at = static_cast<NodeHandle>((x & 7) + kSide * ((y & 7) + kSide * (z & 7)));
  return (pages_[near]->block * LatticeGrid::kBlock + at) << kPageBits | near;
}

}  // namespace plan
