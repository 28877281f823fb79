#include "plan/lattice/lattice.h"

#include <fmt/format.h>

#include <bit>

#include "geom/base/error.h"

namespace plan {
namespace {

// Adds the bits of the edges that end in a node: those of its neighbours. `masks` points at the
// node in an array with these strides.
template <class Strides>
std::uint32_t mirrored(const std::uint32_t* masks, const Strides& strides, int directions) {
  std::uint32_t mask = *masks;
  for (int d = 0; d < directions; ++d) {
    mask |= (masks[-strides[static_cast<std::size_t>(d)]] >> d & 1u) << (kHalfDirections + d);
  }
  return mask;
}

constexpr std::array<std::ptrdiff_t, kHalfDirections> strides_of(std::ptrdiff_t side) {
  constexpr int kHalf[kHalfDirections][3] = {
      {1, 0, 0}, {0, 1, 0},  {0, 0, 1}, {1, 1, 0},  {1, -1, 0}, {1, 0, 1},  {1, 0, -1},
      {0, 1, 1}, {0, 1, -1}, {1, 1, 1}, {1, 1, -1}, {1, -1, 1}, {1, -1, -1}};
  std::array<std::ptrdiff_t, kHalfDirections> out{};
  for (std::size_t d = 0; d < kHalfDirections; ++d) {
    out[d] = kHalf[d][0] + side * (kHalf[d][1] + side * kHalf[d][2]);
  }
  return out;
}

}  // namespace

const std::array<std::array<int, 3>, kDirections> kDirection = {{
    {1, 0, 0},  {0, 1, 0},    {0, 0, 1},   {1, 1, 0},   {1, -1, 0},  {1, 0, 1},   {1, 0, -1},
    {0, 1, 1},  {0, 1, -1},   {1, 1, 1},   {1, 1, -1},  {1, -1, 1},  {1, -1, -1}, {-1, 0, 0},
    {0, -1, 0}, {0, 0, -1},   {-1, -1, 0}, {-1, 1, 0},  {-1, 0, -1}, {-1, 0, 1},  {0, -1, -1},
    {0, -1, 1}, {-1, -1, -1}, {-1, -1, 1}, {-1, 1, -1}, {-1, 1, 1},
}};

int half_directions(Connectivity connectivity) { return static_cast<int>(connectivity) / 2; }

Index3 LatticeGrid::blocks() const {
  Index3 out;
  for (std::size_t k = 0; k < 3; ++k) out[k] = (dims[k] + kSide - 1) / kSide;
  return out;
}

std::size_t LatticeGrid::block_count() const {
  const Index3 n = blocks();
  return static_cast<std::size_t>(n[0] * n[1] * n[2]);
}

Index3 LatticeGrid::block_low(std::size_t block) const {
  const Index3 n = blocks();
  const auto b = static_cast<std::int64_t>(block);
  return {b % n[0] * kSide, b / n[0] % n[1] * kSide, b / (n[0] * n[1]) * kSide};
}

std::uint32_t LatticeGrid::possible(const Index3& node) const {
  const int directions = half_directions(spec.connectivity);
  bool inner = true;
  for (std::size_t k = 0; k < 3; ++k) inner = inner && node[k] > 0 && node[k] + 1 < dims[k];
  if (inner) return (1u << directions) - 1;
  std::uint32_t mask = 0;
  for (int d = 0; d < directions; ++d) {
    const auto& [dx, dy, dz] = kDirection[d];
    if (contains({node[0] + dx, node[1] + dy, node[2] + dz})) mask |= 1u << d;
  }
  return mask;
}

Lattice::Lattice(LatticeGrid grid, geom::Provenance made_for,
                 std::shared_ptr<const MaskSource> source)
    : grid_(grid), made_for_(std::move(made_for)), source_(std::move(source)) {}

std::size_t Lattice::size() const {
  return static_cast<std::size_t>(grid_.dims[0] * grid_.dims[1] * grid_.dims[2]);
}

void Lattice::read(std::size_t block, Block& masks) const {
  constexpr std::int64_t kWide = LatticeGrid::kSide + 2;  // the block and the nodes around it
  constexpr auto kStrides = strides_of(kWide);
  const Index3 low = grid_.block_low(block);
  std::array<std::uint32_t, kWide * kWide * kWide> near;
  source_->read({low[0] - 1, low[1] - 1, low[2] - 1}, {kWide, kWide, kWide}, near.data());
  const int directions = half_directions(grid_.spec.connectivity);
  std::size_t n = 0;
  for (std::int64_t k = 1; k + 1 < kWide; ++k) {
    for (std::int64_t j = 1; j + 1 < kWide; ++j) {
      for (std::int64_t i = 1; i + 1 < kWide; ++i, ++n) {
        const std::uint32_t* const at = near.data() + i + kWide * (j + kWide * k);
        std::uint32_t to_blocked = 0;
        for (int d = 0; d < directions; ++d) {
          const std::uint32_t other = at[kStrides[static_cast<std::size_t>(d)]];
          to_blocked |= (*at >> d & 1u) & ~(other >> 31);
        }
        if (to_blocked) {
          throw geom::InputError(
              source_->name(),
              {.says = fmt::format("node {} of block {} has an edge to a blocked node", n, block)});
        }
        masks[n] = mirrored(at, kStrides, directions);
      }
    }
  }
}

std::uint32_t Lattice::mask(std::size_t node) const {
  const Index3 i = index(node);
  std::array<std::uint32_t, 27> near;
  source_->read({i[0] - 1, i[1] - 1, i[2] - 1}, {3, 3, 3}, near.data());
  return mirrored(near.data() + 13, strides_of(3), half_directions(grid_.spec.connectivity));
}

std::int64_t Lattice::offset(int direction) const {
  const auto& [dx, dy, dz] = kDirection[direction];
  return dx + grid_.dims[0] * (dy + grid_.dims[1] * dz);
}

Index3 Lattice::index(std::size_t node) const {
  const auto n = static_cast<std::int64_t>(node);
  const Index3& dims = grid_.dims;
  return {n % dims[0], n / dims[0] % dims[1], n / (dims[0] * dims[1])};
}

std::optional<std::size_t> Lattice::node(const Index3& i) const {
  if (!grid_.contains(i)) return std::nullopt;
  return static_cast<std::size_t>(i[0] + grid_.dims[0] * (i[1] + grid_.dims[1] * i[2]));
}

LatticeCounts Lattice::counts() const {
  LatticeCounts out;
  Block masks;
  for (std::size_t b = 0; b < grid_.block_count(); ++b) {
    read(b, masks);
    for (const std::uint32_t mask : masks) {
      out.nodes += mask >> 31;
      out.edges += static_cast<std::size_t>(std::popcount(mask & ((1u << kHalfDirections) - 1)));
    }
  }
  return out;
}

}  // namespace plan
