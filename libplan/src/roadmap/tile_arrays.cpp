#include <fmt/format.h>

#include "geom/base/error.h"
#include "roadmap_arrays.h"
#include "tile_reader.h"

namespace plan {
namespace {

// A member of each part, one after the other.
template <class T>
geom::NamedArray joined(std::string name, std::span<const Roadmap> parts,
                        std::span<const T> Roadmap::*member, std::size_t columns = 0) {
  std::size_t size = 0;
  geom::NamedArray out = geom::named_array<T>(std::move(name), {}, columns);
  out.pieces.clear();
  for (const Roadmap& part : parts) {
    size += (part.*member).size();
    out.pieces.push_back(std::as_bytes(part.*member));
  }
  out.shape[0] = columns ? size / columns : size;
  return out;
}

}  // namespace

TileArrays::TileArrays(std::span<const Roadmap> parts) : parts_(parts) {
  std::optional<std::uint64_t> last;
  for (const Roadmap& part : parts) {
    const TileReader reader(part);
    const std::uint64_t bends_before = first_.back();
    const std::uint64_t edges_before = edges_.back();
    for (std::size_t t = 0; t < part.tiles(); ++t) {
      const std::uint64_t code = code_of(reader.square(t));
      const TileReader::Range bends = reader.bends(t);
      const TileReader::Range edges = reader.edges(t);
      if ((last && code <= *last) || first_.back() != bends_before + bends.begin ||
          edges_.back() != edges_before + edges.begin) {
        throw geom::InputError(part.source, {.says = fmt::format("tile {} is out of order", t),
                                             .advice = "the file is damaged"});
      }
      last = code;
      first_.push_back(bends_before + bends.end);
      edges_.push_back(edges_before + edges.end);
    }
    if (first_.back() - bends_before != part.bends() ||
        edges_.back() - edges_before != part.edge_to.size()) {
      throw geom::InputError(part.source, {.says = "there are bends or edges of no tile"});
    }
  }
}

void TileArrays::append_to(std::vector<geom::NamedArray>& arrays) const {
  arrays.push_back(joined("tile_index", parts_, &Roadmap::tile_index, 2));
  arrays.push_back(joined("tile_extent", parts_, &Roadmap::tile_extent, 6));
  arrays.push_back(geom::named_array<std::uint64_t>("tile_first", first_));
  arrays.push_back(geom::named_array<std::uint64_t>("tile_edges", edges_));
  arrays.push_back(joined("bend_position", parts_, &Roadmap::bend_position, 3));
  arrays.push_back(joined("bend_axis", parts_, &Roadmap::bend_axis));
  arrays.push_back(joined("bend_outward", parts_, &Roadmap::bend_outward, 2));
  arrays.push_back(joined("edge_first", parts_, &Roadmap::edge_first));
  arrays.push_back(joined("edge_split", parts_, &Roadmap::edge_split));
  arrays.push_back(joined("edge_to", parts_, &Roadmap::edge_to));
}

Roadmap open_tiles(const geom::ArrayArchive& archive) {
  Roadmap out;
  out.tile_index = archive.array<std::int32_t>("tile_index", 2);
  out.tile_extent = archive.array<float>("tile_extent", 6);
  out.tile_first = archive.array<std::uint64_t>("tile_first");
  out.tile_edges = archive.array<std::uint64_t>("tile_edges");
  out.bend_position = archive.array<double>("bend_position", 3);
  out.bend_axis = archive.array<std::int8_t>("bend_axis");
  out.bend_outward = archive.array<std::int8_t>("bend_outward", 2);
  out.edge_first = archive.array<std::uint32_t>("edge_first");
  out.edge_split = archive.array<std::uint32_t>("edge_split");
  out.edge_to = archive.array<std::uint32_t>("edge_to");
  out.keep_alive = archive.keep_alive();
  out.source = archive.name();
  const std::size_t tiles = out.tiles();
  const std::size_t bends = out.bends();
  if (out.tile_extent.size() != 6 * tiles || out.tile_first.size() != tiles + 1 ||
      out.tile_edges.size() != tiles + 1 || out.bend_position.size() != 3 * bends ||
      out.bend_outward.size() != 2 * bends || out.edge_first.size() != bends ||
      out.edge_split.size() != bends) {
    throw geom::InputError(archive.name(),
                           {.says = "the arrays of tiles, bends and edges do not fit each other"});
  }
  return out;
}

}  // namespace plan
