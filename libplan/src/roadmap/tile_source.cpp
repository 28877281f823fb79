#include "tile_source.h"

#include <fmt/format.h>

#include "geom/base/error.h"
#include "tile_reader.h"

namespace plan {
namespace {

class FileTiles : public TileSource {
 public:
  explicit FileTiles(const Roadmap& roadmap) : roadmap_(roadmap), reader_(roadmap) {}

  const Squares& squares() const override { return reader_.squares(); }
  std::size_t tiles() const override { return roadmap_.tiles(); }
  Square square(std::size_t tile) const override { return reader_.square(tile); }
  geom::Aabb extent(std::size_t tile) const override { return reader_.extent(tile); }
  const std::string& name() const override { return roadmap_.source; }

  std::vector<Bend> bends(std::size_t tile) override {
    const TileReader::Range range = reader_.bends(tile);
    std::vector<Bend> out;
    out.reserve(range.size());
    for (std::size_t i = range.begin; i < range.end; ++i) {
      reader_.split_of(tile, i);
      out.push_back(reader_.bend(i));
    }
    return out;
  }

  Edges edges(std::size_t tile, std::uint32_t local) override {
    const std::size_t bend = reader_.bends(tile).begin + local;
    const auto all = reader_.edges_of(tile, bend);
    const std::size_t split = reader_.split_of(tile, bend);
    return {all.first(split), all.subspan(split)};
  }

 private:
  const Roadmap& roadmap_;
  TileReader reader_;
};

}  // namespace

std::optional<std::size_t> TileSource::find(const Square& wanted) const {
  const std::uint64_t code = code_of(wanted);
  std::size_t low = 0;
  std::size_t high = tiles();
  while (low < high) {
    const std::size_t middle = low + (high - low) / 2;
    code_of(square(middle)) < code ? low = middle + 1 : high = middle;
  }
  if (low == tiles() || !(square(low) == wanted)) return std::nullopt;
  return low;
}

std::size_t TileSource::target(std::size_t tile, std::uint32_t edge) const {
  const std::uint32_t slot = edge >> Squares::kLocalBits;
  if (slot < squares().slots()) {
    if (const auto found = find(squares().beside(square(tile), slot))) return *found;
  }
  throw geom::InputError(name(), {.says = "an edge leads to a tile that is not there",
                                  .advice = "the file is damaged"});
}

std::unique_ptr<TileSource> tiles_of(const Roadmap& roadmap) {
  return std::make_unique<FileTiles>(roadmap);
}

}  // namespace plan
