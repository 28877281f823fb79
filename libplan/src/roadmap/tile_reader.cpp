#include "tile_reader.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "geom/base/error.h"

namespace plan {

void TileReader::refuse(std::string_view what) const {
  throw geom::InputError(roadmap_->source,
                         {.says = std::string(what), .advice = "the file is damaged"});
}

std::optional<std::size_t> TileReader::find(const Square& wanted) const {
  const std::uint64_t code = code_of(wanted);
  std::size_t low = 0;
  std::size_t high = roadmap_->tiles();
  while (low < high) {
    const std::size_t middle = low + (high - low) / 2;
    code_of(square(middle)) < code ? low = middle + 1 : high = middle;
  }
  if (low == roadmap_->tiles() || !(square(low) == wanted)) return std::nullopt;
  return low;
}

geom::Aabb TileReader::extent(std::size_t tile) const {
  const float* const e = &roadmap_->tile_extent[6 * tile];
  const geom::Aabb box{Vec3(e[0], e[1], e[2]), Vec3(e[3], e[4], e[5])};
  const bool sound =
      (box.min.array() <= box.max.array()).all() &&
      box.min.cwiseAbs().cwiseMax(box.max.cwiseAbs()).maxCoeff() <= 2 * geom::kLargestCoordinate;
  if (!sound) refuse(fmt::format("tile {} has an extent that is impossible", tile));
  return box;
}

TileReader::Range TileReader::bends(std::size_t tile) const {
  const std::uint64_t begin = roadmap_->tile_first[tile];
  const std::uint64_t end = roadmap_->tile_first[tile + 1];
  if (begin > end || end > roadmap_->bends() || end - begin > Squares::kLocalMask + 1u) {
    refuse(fmt::format("tile {} has a range of bends that is impossible", tile));
  }
  return {begin, end};
}

TileReader::Range TileReader::edges(std::size_t tile) const {
  const std::uint64_t begin = roadmap_->tile_edges[tile];
  const std::uint64_t end = roadmap_->tile_edges[tile + 1];
  if (begin > end || end > roadmap_->edge_to.size()) {
    refuse(fmt::format("tile {} has a range of edges that is impossible", tile));
  }
  return {begin, end};
}

Bend TileReader::bend(std::size_t i) const {
  const Bend bend = roadmap_->bend(i);
  const bool signs = std::abs(bend.outward[0]) == 1 && std::abs(bend.outward[1]) == 1;
  const bool near = (bend.position.array().abs() <= geom::kLargestCoordinate).all();
  if (!near || bend.axis < 0 || bend.axis > 2 || !signs) {
    refuse(fmt::format("bend {} has a position, axis or sign that is impossible", i));
  }
  return bend;
}

std::span<const std::uint32_t> TileReader::edges_of(std::size_t tile, std::size_t bend) const {
  const Range all = edges(tile);
  const bool last = bend + 1 == bends(tile).end;
  const std::size_t begin = roadmap_->edge_first[bend];
  const std::size_t end = last ? all.size() : roadmap_->edge_first[bend + 1];
  if (begin > end || end > all.size()) {
    refuse(fmt::format("bend {} has a range of edges that is impossible", bend));
  }
  return roadmap_->edge_to.subspan(all.begin + begin, end - begin);
}

std::uint32_t TileReader::split_of(std::size_t tile, std::size_t bend) const {
  const std::uint32_t split = roadmap_->edge_split[bend];
  const std::size_t edges = edges_of(tile, bend).size();
  if (split > edges) {
    refuse(fmt::format("bend {} has a range of edges that is impossible", bend));
  }
  return split;
}

TileReader::Target TileReader::target(std::size_t tile, std::uint32_t edge) const {
  const std::uint32_t slot = edge >> Squares::kLocalBits;
  const std::uint32_t local = edge & Squares::kLocalMask;
  const auto found =
      slot < squares_.slots() ? find(squares_.beside(square(tile), slot)) : std::nullopt;
  const std::size_t there = found ? bends(*found).size() : 0;
  if (local >= there) {
    refuse(fmt::format("an edge leads to bend {} of {} in a tile", local, there));
  }
  return {*found, local};
}

}  // namespace plan
