#include "plan/roadmap/roadmap_fill.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <set>
#include <utility>

#include "bend_tree.h"
#include "bends.h"
#include "owned_tiles.h"
#include "tile_bends.h"
#include "tile_reader.h"
#include "tile_source.h"

namespace plan {
namespace {

constexpr double kPad = 1e-2;  // metres: bends stand off their boxes by less

// The bends of a tile, once it was touched. Never changes.
struct Touched {
  std::vector<Bend> bends;
  BendTree tree;
};

// The edges of a bend.
struct EdgeRow {
  std::vector<std::uint32_t> to;
  std::uint32_t split = 0;

  TileSource::Edges edges() const {
    return {std::span(to).first(split), std::span(to).subspan(split)};
  }
};

// Of bends[0] to the others, as Roadmap says; names[i] is what an edge to bends[i] is.
EdgeRow sorted_row(std::span<const Bend> bends, std::span<const std::uint32_t> names) {
  std::vector<EdgeKey> keys;
  for (std::uint32_t i = 1; i < bends.size(); ++i) keys.push_back(edge_key(bends, 0, i));
  std::sort(keys.begin(), keys.end());
  EdgeRow row;
  for (const EdgeKey& key : keys) {
    row.to.push_back(names[key.to]);
    row.split += !key.second;
  }
  return row;
}

// What a roadmap knows of a tile, by its square.
struct KnownTile {
  const Roadmap* roadmap;
  TileReader reader;
  std::size_t tile;

  std::vector<Bend> bends() const {
    std::vector<Bend> out;
    const TileReader::Range range = reader.bends(tile);
    for (std::size_t i = range.begin; i < range.end; ++i) out.push_back(reader.bend(i));
    return out;
  }

  // Nothing where they are not known.
  std::optional<TileSource::Edges> edges(std::uint32_t local) const {
    const TileReader::Range range = reader.bends(tile);
    const std::size_t bend = range.begin + local;
    if (bend >= range.end || roadmap->edge_split[bend] == kUnknownEdges) return std::nullopt;
    const auto all = reader.edges_of(tile, bend);
    const std::size_t split = reader.split_of(tile, bend);
    return TileSource::Edges{all.first(split), all.subspan(split)};
  }
};

std::optional<KnownTile> known_tile(const std::optional<Roadmap>& roadmap, const Square& square) {
  if (!roadmap) return std::nullopt;
  const TileReader reader(*roadmap);
  const auto tile = reader.find(square);
  if (!tile) return std::nullopt;
  return KnownTile{&*roadmap, reader, *tile};
}

}  // namespace

struct RoadmapFill::Impl : public TileSource {
  Impl(const geom::CollisionScene& on, const RoadmapSpec& of, std::optional<Roadmap> so_far)
      : scene(on), spec(of), grid(of.reach), file(std::move(so_far)) {
    for (const SquareShare& share : squares_of(scene, spec)) codes.push_back(share.code);
    if (file) message_name = file->source;
  }

  const Squares& squares() const override { return grid; }
  std::size_t tiles() const override { return codes.size(); }
  Square square(std::size_t tile) const override { return square_at(codes[tile]); }
  geom::Aabb extent(std::size_t tile) const override {
    return grid.box(square(tile), square(tile), kPad);
  }
  std::vector<Bend> bends(std::size_t tile) override { return touched(tile)->bends; }
  Edges edges(std::size_t tile, std::uint32_t local) override;
  const std::string& name() const override { return message_name; }

  std::shared_ptr<const Touched> touched(std::size_t tile);
  std::vector<Bend> found_bends(std::size_t tile) const;
  EdgeRow found_edges(std::size_t tile, std::uint32_t local);
  void add_tile(OwnedTiles& out, const Square& square, const std::optional<Roadmap>& others) const;

  const geom::CollisionScene& scene;
  RoadmapSpec spec;
  Squares grid;
  std::optional<Roadmap> file;  // what was known at first
  std::string message_name = "roadmap";
  std::vector<std::uint64_t> codes;
  mutable std::mutex mutex;                                               // guards what follows
  std::map<std::uint64_t, std::shared_ptr<const Touched>> touched_tiles;  // by code
  std::map<std::pair<std::uint64_t, std::uint32_t>, EdgeRow> rows;        // that the file has not
};

std::vector<Bend> RoadmapFill::Impl::found_bends(std::size_t tile) const {
  if (const auto known = known_tile(file, square(tile))) return known->bends();
  return bends_of(scene, spec, {&codes[tile], 1}, {}).bends;
}

// Made without the lock: two threads may make the same.
std::shared_ptr<const Touched> RoadmapFill::Impl::touched(std::size_t tile) {
  {
    const std::lock_guard lock(mutex);
    const auto at = touched_tiles.find(codes[tile]);
    if (at != touched_tiles.end()) return at->second;
  }
  std::vector<Bend> bends = found_bends(tile);
  BendTree tree(bends);
  auto made = std::make_shared<const Touched>(Touched{std::move(bends), std::move(tree)});
  const std::lock_guard lock(mutex);
  return touched_tiles.emplace(codes[tile], std::move(made)).first->second;
}

// To all bends within reach, in the order that build_roadmap() gives them.
EdgeRow RoadmapFill::Impl::found_edges(std::size_t tile, std::uint32_t local) {
  const Bend bend = touched(tile)->bends.at(local);
  struct Near {
    std::uint64_t code;
    std::uint32_t slot;
    std::size_t tile;
  };
  std::vector<Near> near;
  for (std::uint32_t slot = 0; slot < grid.slots(); ++slot) {
    const Square beside = grid.beside(square(tile), slot);
    const auto there = find(beside);
    if (!there) continue;
    const geom::Aabb box = extent(*there);
    const Vec3 off = (box.min - bend.position).cwiseMax(bend.position - box.max).cwiseMax(0);
    if (off.norm() <= spec.reach) near.push_back({code_of(beside), slot, *there});
  }
  std::sort(near.begin(), near.end(), [](const Near& a, const Near& b) { return a.code < b.code; });
  std::vector<Bend> bends = {bend};
  std::vector<std::uint32_t> names = {0};
  for (const Near& one : near) {
    const auto there = touched(one.tile);
    std::vector<std::uint32_t> within;
    there->tree.for_near(
        bend.position, spec.reach, [](const BendTree::Node&) { return false; },
        [&](std::uint32_t j) { within.push_back(j); });
    std::sort(within.begin(), within.end());
    for (const std::uint32_t j : within) {
      const Bend& other = there->bends[j];
      if (one.tile == tile && j == local) continue;
      if (!linked(scene, bend, other, spec.reach)) continue;
      bends.push_back(other);
      names.push_back(one.slot << Squares::kLocalBits | j);
    }
  }
  return sorted_row(bends, names);
}

TileSource::Edges RoadmapFill::Impl::edges(std::size_t tile, std::uint32_t local) {
  if (const auto known = known_tile(file, square(tile))) {
    if (const auto edges = known->edges(local)) return *edges;
  }
  const std::pair key(codes[tile], local);
  {
    const std::lock_guard lock(mutex);
    if (const auto at = rows.find(key); at != rows.end()) return at->second.edges();
  }
  EdgeRow row = found_edges(tile, local);
  const std::lock_guard lock(mutex);
  return rows.emplace(key, std::move(row)).first->second.edges();
}

// What is known of it by anyone.
void RoadmapFill::Impl::add_tile(OwnedTiles& out, const Square& square,
                                 const std::optional<Roadmap>& others) const {
  const std::uint64_t code = code_of(square);
  const auto own = known_tile(file, square);
  const auto theirs = known_tile(others, square);
  const auto touched = touched_tiles.find(code);
  const std::vector<Bend> bends = own                              ? own->bends()
                                  : touched != touched_tiles.end() ? touched->second->bends
                                                                   : theirs->bends();
  if (bends.empty()) return;
  out.tile_index.insert(out.tile_index.end(), {square.column, square.row});
  out.add_extent(bends);
  for (std::uint32_t i = 0; i < bends.size(); ++i) {
    const auto row = rows.find({code, i});
    std::optional<TileSource::Edges> edges;
    if (row != rows.end()) edges = row->second.edges();
    if (!edges && own) edges = own->edges(i);
    if (!edges && theirs) edges = theirs->edges(i);
    out.add(bends[i]);
    out.edge_first.push_back(
        static_cast<std::uint32_t>(out.edge_to.size() - out.tile_edges.back()));
    out.edge_split.push_back(edges ? static_cast<std::uint32_t>(edges->first.size())
                                   : kUnknownEdges);
    if (!edges) continue;
    out.edge_to.insert(out.edge_to.end(), edges->first.begin(), edges->first.end());
    out.edge_to.insert(out.edge_to.end(), edges->second.begin(), edges->second.end());
  }
  out.tile_first.push_back(out.bend_axis.size());
  out.tile_edges.push_back(out.edge_to.size());
}

RoadmapFill::RoadmapFill(const geom::CollisionScene& scene, const RoadmapSpec& spec,
                         std::optional<Roadmap> known)
    : impl_(std::make_unique<Impl>(scene, spec, std::move(known))) {}
RoadmapFill::~RoadmapFill() = default;

const RoadmapSpec& RoadmapFill::spec() const { return impl_->spec; }
TileSource& RoadmapFill::source() { return *impl_; }

bool RoadmapFill::grew() const {
  const std::lock_guard lock(impl_->mutex);
  return !impl_->rows.empty();
}

Roadmap RoadmapFill::known(const std::optional<Roadmap>& others) const {
  const std::lock_guard lock(impl_->mutex);
  std::set<std::uint64_t> codes;
  for (const auto& [code, tile] : impl_->touched_tiles) codes.insert(code);
  for (const std::optional<Roadmap>* roadmap :
       {static_cast<const std::optional<Roadmap>*>(&impl_->file), &others}) {
    if (!*roadmap) continue;
    const TileReader reader(**roadmap);
    for (std::size_t t = 0; t < (*roadmap)->tiles(); ++t) codes.insert(code_of(reader.square(t)));
  }
  const auto owned = std::make_shared<OwnedTiles>();
  for (const std::uint64_t code : codes) impl_->add_tile(*owned, square_at(code), others);
  Roadmap out = roadmap_of(impl_->spec, owned);
  out.made_for = geom::provenance_of(impl_->scene);
  out.filled = true;
  return out;
}

}  // namespace plan
