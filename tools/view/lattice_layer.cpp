#include <fmt/format.h>

#include <array>

#include "geom/base/error.h"
#include "layers.h"

namespace view {
namespace {

using plan::Index3;
using plan::Lattice;
using plan::LatticeGrid;

constexpr std::size_t kMostNodes = std::size_t{1} << 23;  // a byte each in the page

// What the page draws of a node: bit 0 for the node, then edges towards these, in ENU.
constexpr std::array<std::array<int, 3>, 5> kShown = {
    {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {1, -1, 0}}};

// Bits of Lattice's masks for kShown.
std::array<int, 5> shown_bits(bool swapped) {
  std::array<int, 5> bits{};
  for (std::size_t s = 0; s < kShown.size(); ++s) {
    std::array<int, 3> wanted = kShown[s];
    if (swapped) std::swap(wanted[0], wanted[1]);
    for (int d = 0; d < plan::kDirections; ++d) {
      if (plan::kDirection[d] == wanted) bits[s] = d;
    }
  }
  return bits;
}

std::uint8_t shown(std::uint32_t mask, const std::array<int, 5>& bits) {
  std::uint8_t out = (mask & Lattice::kNode) ? 1 : 0;
  for (std::size_t s = 0; s < bits.size(); ++s) out |= (mask >> bits[s] & 1u) << (s + 1);
  return out;
}

// A byte a node, east fastest, then north, then up.
std::vector<std::uint8_t> shown_masks(const Lattice& lattice, bool swapped) {
  const LatticeGrid& grid = lattice.grid();
  const std::array<int, 5> bits = shown_bits(swapped);
  std::vector<std::uint8_t> out(lattice.size());
  Lattice::Block masks;
  for (std::size_t b = 0; b < grid.block_count(); ++b) {
    lattice.read(b, masks);
    const Index3 low = grid.block_low(b);
    for (std::size_t n = 0; n < masks.size(); ++n) {
      const auto at = static_cast<std::int64_t>(n);
      constexpr std::int64_t kSide = LatticeGrid::kSide;
      const Index3 i = {low[0] + at % kSide, low[1] + at / kSide % kSide,
                        low[2] + at / (kSide * kSide)};
      if (!grid.contains(i)) continue;
      const std::int64_t row = swapped ? i[1] + grid.dims[1] * i[0] : i[0] + grid.dims[0] * i[1];
      const std::int64_t slot = row + grid.dims[0] * grid.dims[1] * i[2];
      out[static_cast<std::size_t>(slot)] = shown(masks[n], bits);
    }
  }
  return out;
}

}  // namespace

Json lattice_layer(const cli::Read<Lattice>& read, const LocalFrame& frame, Bundle& bundle) {
  const Lattice& lattice = read.record;
  if (lattice.size() > kMostNodes) {
    throw geom::InputError(
        read.source,
        {.expected = fmt::format("a lattice of at most {} nodes to show", kMostNodes),
         .found = fmt::to_string(lattice.size()),
         .advice = "build a coarser one, or one of a part of the map (skyway-map crop)"});
  }
  const bool swapped = frame.axes == geom::Axes::neu;
  const Index3& d = lattice.dims();
  const plan::LatticeCounts counts = lattice.counts();
  return {{"name", read.source},
          {"spacing", lattice.spec().spacing},
          {"connectivity", static_cast<int>(lattice.spec().connectivity)},
          {"dims", {d[swapped ? 1 : 0], d[swapped ? 0 : 1], d[2]}},
          {"first", as_json(frame.at(lattice.grid().position({0, 0, 0})))},
          {"nodes", counts.nodes},
          {"edges", counts.edges},
          {"mask", bundle.add(std::span<const std::uint8_t>(shown_masks(lattice, swapped)))}};
}

}  // namespace view
