#pragma once

// The tiles of a roadmap that searches have touched, and boxes within boxes over all of them.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "bend_tree.h"
#include "plan/roadmap/roadmap.h"
#include "tile_reader.h"

namespace plan {

// Bends are numbered here as they are loaded, which says nothing about their order. Nothing is read
// before it is asked for, and what is read is verified. The roadmap must outlive this.
class LoadedTiles {
 public:
  // A box, and what is in it: bends or other nodes, once it is open.
  struct Node {
    BendTree::Node tree;
    bool open = true;
  };

  explicit LoadedTiles(const Roadmap& roadmap);
  LoadedTiles(std::vector<Bend> bends, const BendTree& tree);  // one tile without edges

  const std::vector<Bend>& bends() const { return bends_; }
  std::uint32_t root() const { return root_; }
  bool empty() const { return nodes_.empty(); }
  const BendTree::Node& node(std::uint32_t i) const { return nodes_[i].tree; }

  // The node, once what is in it was loaded.
  const BendTree::Node& opened(std::uint32_t i) {
    if (!nodes_[i].open) open(i);
    return nodes_[i].tree;
  }

  // The edges of a bend, and its tile, which is to be asked with them.
  struct Edges {
    std::uint32_t tile;
    std::span<const std::uint32_t> first;
    std::span<const std::uint32_t> second;
  };
  Edges edges_of(std::uint32_t bend);

  // The bend that an edge leads to, where its tile is known by now to be near.
  static constexpr std::uint32_t kNotYet = 0xffffffffu;
  std::uint32_t known_target(std::uint32_t tile, std::uint32_t edge) const {
    const Run& near = near_[std::size_t{tile} << 8 | edge >> Squares::kLocalBits];
    const std::uint32_t local = edge & Squares::kLocalMask;
    return local < near.count ? near.first + local : kNotYet;
  }

  // The same, which may load a tile.
  std::uint32_t target(std::uint32_t tile, std::uint32_t edge) {
    const std::uint32_t known = known_target(tile, edge);
    return known == kNotYet ? load_target(tile, edge) : known;
  }

  std::size_t tiles() const { return tiles_.size(); }

 private:
  struct Run {  // of bends, as they are numbered here
    std::uint32_t first = 0;
    std::uint32_t count = 0;
  };
  struct Tile {
    std::size_t number;  // in the roadmap
    Run run;
  };
  struct Range {  // of the roadmap's tiles
    std::size_t begin;
    std::size_t end;
  };

  void open(std::uint32_t node);
  void open_tile(std::uint32_t node, std::size_t tile);
  void split(std::uint32_t node, const Range& range);
  Node unopened(const Range& range);
  void add_tree(std::uint32_t node, const BendTree& tree, std::uint32_t first);
  std::uint32_t load(std::size_t tile);
  std::uint32_t load_target(std::uint32_t tile, std::uint32_t edge);

  std::optional<TileReader> reader_;  // none where there are no edges
  std::vector<Bend> bends_;
  std::vector<std::uint32_t> tile_of_;  // each bend
  std::vector<Tile> tiles_;
  std::vector<Run> near_;  // of each tile, by the high bits of an edge; none where it is not known
  std::unordered_map<std::size_t, std::uint32_t> loaded_;  // of the roadmap's tiles
  std::vector<Node> nodes_;
  std::vector<Range> ranges_;  // of nodes that are not open: `first` is a place in this
  std::uint32_t root_ = 0;
};

}  // namespace plan
