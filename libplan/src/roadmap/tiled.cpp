#include "tiled.h"

#include <fmt/format.h>

#include <limits>
#include <utility>

#include "geom/base/error.h"
#include "geom/base/parallel.h"
#include "owned_tiles.h"
#include "tile_reader.h"

namespace plan {
namespace {

void require_edges_fit(std::uint64_t edges) {
  if (edges <= std::numeric_limits<std::uint32_t>::max()) return;
  throw geom::InputError("roadmap",
                         {.says = fmt::format("a tile has {} edges, more than 2^32", edges),
                          .advice = "use a smaller reach"});
}

// Numbers of bends become squares and numbers in them.
void name_targets(const TileBends& bends, std::size_t begin, std::size_t end, EdgeLists& edges,
                  const Squares& squares, unsigned threads) {
  const std::size_t zero = bends.first[begin];
  geom::parallel_for(end - begin, {threads, {}}, [&](std::size_t n) {
    const std::size_t t = begin + n;
    const std::uint64_t from = edges.first[bends.first[t] - zero];
    const std::uint64_t to = edges.first[bends.first[t + 1] - zero];
    std::size_t there = t;
    for (std::uint64_t e = from; e < to; ++e) {
      const std::uint32_t bend = edges.to[e];
      if (bend < bends.first[there] || bend >= bends.first[there + 1]) there = bends.tile_of(bend);
      edges.to[e] = squares.slot(bends.squares[t], bends.squares[there]) << Squares::kLocalBits |
                    (bend - bends.first[there]);
    }
  });
}

}  // namespace

Roadmap tiled(const RoadmapSpec& spec, const TileBends& bends, std::size_t begin, std::size_t end,
              EdgeLists edges, unsigned threads) {
  const auto owned = std::make_shared<OwnedTiles>();
  const Squares squares(spec.reach);
  name_targets(bends, begin, end, edges, squares, threads);
  const std::size_t zero = bends.first[begin];
  for (std::size_t t = begin; t < end; ++t) {
    const std::size_t first = bends.first[t];
    const std::span in_tile = std::span(bends.bends).subspan(first, bends.first[t + 1] - first);
    owned->tile_index.insert(owned->tile_index.end(),
                             {bends.squares[t].column, bends.squares[t].row});
    owned->add_extent(in_tile);
    for (std::size_t i = 0; i < in_tile.size(); ++i) {
      owned->add(in_tile[i]);
      owned->edge_first.push_back(
          static_cast<std::uint32_t>(edges.first[first - zero + i] - owned->tile_edges.back()));
    }
    owned->tile_first.push_back(bends.first[t + 1] - zero);
    owned->tile_edges.push_back(edges.first[bends.first[t + 1] - zero]);
    require_edges_fit(owned->tile_edges.back() - edges.first[first - zero]);
  }
  owned->edge_split = std::move(edges.split);
  owned->edge_to = std::move(edges.to);
  return roadmap_of(spec, owned);
}

FlatRoadmap flattened(const Roadmap& roadmap) {
  const TileReader reader(roadmap);
  FlatRoadmap out;
  out.edges.to.reserve(roadmap.edge_to.size());
  for (std::size_t t = 0; t < roadmap.tiles(); ++t) {
    const TileReader::Range bends = reader.bends(t);
    out.tiles.squares.push_back(reader.square(t));
    out.tiles.first.push_back(static_cast<std::uint32_t>(bends.end));
    for (std::size_t i = bends.begin; i < bends.end; ++i) {
      out.tiles.bends.push_back(reader.bend(i));
      for (const std::uint32_t edge : reader.edges_of(t, i)) {
        const TileReader::Target target = reader.target(t, edge);
        out.edges.to.push_back(
            static_cast<std::uint32_t>(reader.bends(target.tile).begin + target.local));
      }
      out.edges.first.push_back(out.edges.to.size());
      out.edges.split.push_back(reader.split_of(t, i));
    }
  }
  return out;
}

}  // namespace plan
