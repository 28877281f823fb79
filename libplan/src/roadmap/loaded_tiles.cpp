#include "loaded_tiles.h"

#include <bit>
#include <limits>

#include "geom/base/error.h"
#include "geom/base/rounding.h"

namespace plan {
namespace {

constexpr double kPad = 1e-2;  // metres: more than the rounding that puts a bend into a square

BendTree::Node node_of(const geom::Aabb& box) {
  BendTree::Node node{};
  for (int k = 0; k < 3; ++k) {
    node.min[k] = geom::float_down(box.min[k]);
    node.max[k] = geom::float_up(box.max[k]);
  }
  return node;
}

}  // namespace

LoadedTiles::LoadedTiles(const Roadmap& roadmap) : reader_(roadmap) {
  if (roadmap.tiles() > 0) nodes_.push_back(unopened({0, roadmap.tiles()}));
}

LoadedTiles::LoadedTiles(std::vector<Bend> bends, const BendTree& tree) : bends_(std::move(bends)) {
  if (tree.empty()) return;
  nodes_.emplace_back();
  add_tree(0, tree, 0);
}

// The tree of bends that are numbered from `first` on, in the place of a node.
void LoadedTiles::add_tree(std::uint32_t at, const BendTree& tree, std::uint32_t first) {
  if (tree.empty()) {
    nodes_[at].tree.leaf = true;
    nodes_[at].tree.count = 0;
    nodes_[at].open = true;
    return;
  }
  const auto base = static_cast<std::uint32_t>(nodes_.size());
  for (std::uint32_t i = 0; i < tree.root(); ++i) nodes_.push_back({tree.node(i), true});
  nodes_[at] = {tree.node(tree.root()), true};
  const auto shift = [&](BendTree::Node& node) { node.first += node.leaf ? first : base; };
  shift(nodes_[at].tree);
  for (std::size_t i = base; i < nodes_.size(); ++i) shift(nodes_[i].tree);
}

void LoadedTiles::open(std::uint32_t at) {
  const Range range = ranges_[nodes_[at].tree.first];
  if (range.end - range.begin == 1) {
    open_tile(at, range.begin);
  } else {
    split(at, range);
  }
}

void LoadedTiles::open_tile(std::uint32_t at, std::size_t tile) {
  const Run run = tiles_[load(tile)].run;
  add_tree(at, BendTree(std::span(bends_).subspan(run.first, run.count)), run.first);
}

// Into the quarters of the smallest square on the curve that holds all of them.
void LoadedTiles::split(std::uint32_t at, const Range& range) {
  const auto code = [&](std::size_t tile) { return code_of(reader_->square(tile)); };
  const std::uint64_t differing = code(range.begin) ^ code(range.end - 1);
  const int quarter = differing ? (std::bit_width(differing) - 1) & ~1 : 0;
  std::vector<Node> children;
  for (std::size_t begin = range.begin; begin < range.end;) {
    const std::uint64_t own = code(begin) >> quarter;
    std::size_t low = begin + 1;
    std::size_t high = range.end;
    while (low < high) {
      const std::size_t middle = low + (high - low) / 2;
      code(middle) >> quarter == own ? low = middle + 1 : high = middle;
    }
    if (low - begin == range.end - range.begin || children.size() == 4) {
      reader_->refuse("tiles are out of order");
    }
    children.push_back(unopened({begin, low}));
    begin = low;
  }
  Node& node = nodes_[at];
  node.tree.first = static_cast<std::uint32_t>(nodes_.size());
  node.tree.count = static_cast<std::uint16_t>(children.size());
  node.tree.leaf = false;
  node.open = true;
  nodes_.insert(nodes_.end(), children.begin(), children.end());
}

LoadedTiles::Node LoadedTiles::unopened(const Range& range) {
  Node node{{}, false};
  if (range.end - range.begin == 1) {
    node.tree = node_of(reader_->extent(range.begin));
  } else {
    const std::uint64_t first = code_of(reader_->square(range.begin));
    const std::uint64_t last = code_of(reader_->square(range.end - 1));
    const int bits = (std::bit_width(first ^ last) + 1) & ~1;
    const std::uint64_t below = bits < 64 ? (std::uint64_t{1} << bits) - 1 : ~std::uint64_t{0};
    node.tree =
        node_of(reader_->squares().box(square_at(first & ~below), square_at(first | below), kPad));
  }
  node.tree.first = static_cast<std::uint32_t>(ranges_.size());
  ranges_.push_back(range);
  return node;
}

std::uint32_t LoadedTiles::load(std::size_t number) {
  if (const auto at = loaded_.find(number); at != loaded_.end()) return at->second;
  const TileReader::Range range = reader_->bends(number);
  if (bends_.size() + range.size() > std::numeric_limits<std::uint32_t>::max() - 1) {
    throw geom::InputError("roadmap", {.says = "a search touches more than 2^32 bends"});
  }
  const auto tile = static_cast<std::uint32_t>(tiles_.size());
  const Run run = {static_cast<std::uint32_t>(bends_.size()),
                   static_cast<std::uint32_t>(range.size())};
  std::vector<Bend> bends;
  bends.reserve(range.size());
  for (std::size_t i = range.begin; i < range.end; ++i) {
    reader_->split_of(number, i);
    bends.push_back(reader_->bend(i));
  }
  tiles_.push_back({number, run});
  bends_.insert(bends_.end(), bends.begin(), bends.end());
  tile_of_.resize(bends_.size(), tile);
  near_.resize(tiles_.size() << 8);
  loaded_.emplace(number, tile);
  return tile;
}

std::uint32_t LoadedTiles::load_target(std::uint32_t from, std::uint32_t edge) {
  const TileReader::Target target = reader_->target(tiles_[from].number, edge);
  const Run run = tiles_[load(target.tile)].run;
  near_[std::size_t{from} << 8 | edge >> Squares::kLocalBits] = run;
  return run.first + target.local;
}

LoadedTiles::Edges LoadedTiles::edges_of(std::uint32_t bend) {
  const Tile& tile = tiles_[tile_of_[bend]];
  const std::size_t i = reader_->bends(tile.number).begin + (bend - tile.run.first);
  const auto all = reader_->edges_of(tile.number, i);
  const std::size_t split = reader_->split_of(tile.number, i);
  return {tile_of_[bend], all.first(split), all.subspan(split)};
}

}  // namespace plan
