#include "plan/lattice.h"

#include <bit>
#include <cmath>

namespace plan {

const std::array<std::array<int, 3>, kDirections> kDirection = {{
    {1, 0, 0},  {0, 1, 0},    {0, 0, 1},   {1, 1, 0},   {1, -1, 0},  {1, 0, 1},   {1, 0, -1},
    {0, 1, 1},  {0, 1, -1},   {1, 1, 1},   {1, 1, -1},  {1, -1, 1},  {1, -1, -1}, {-1, 0, 0},
    {0, -1, 0}, {0, 0, -1},   {-1, -1, 0}, {-1, 1, 0},  {-1, 0, -1}, {-1, 0, 1},  {0, -1, -1},
    {0, -1, 1}, {-1, -1, -1}, {-1, -1, 1}, {-1, 1, -1}, {-1, 1, 1},
}};

int half_directions(Connectivity connectivity) { return static_cast<int>(connectivity) / 2; }

Lattice::Lattice(LatticeSpec spec, Index3 first, Index3 dims, geom::Provenance made_for,
                 std::vector<std::uint32_t> masks)
    : spec_(spec),
      first_(first),
      dims_(dims),
      made_for_(std::move(made_for)),
      masks_(std::move(masks)) {
  for (int d = 0; d < kDirections; ++d) {
    const auto& [dx, dy, dz] = kDirection[d];
    offset_[d] = dx + dims_[0] * (dy + dims_[1] * dz);
    length_[d] = spec_.spacing * std::sqrt(static_cast<double>(dx * dx + dy * dy + dz * dz));
  }
}

Index3 Lattice::index(std::size_t node) const {
  const auto n = static_cast<std::int64_t>(node);
  return {n % dims_[0], n / dims_[0] % dims_[1], n / (dims_[0] * dims_[1])};
}

std::optional<std::size_t> Lattice::node(const Index3& i) const {
  for (int k = 0; k < 3; ++k) {
    if (i[k] < 0 || i[k] >= dims_[k]) return std::nullopt;
  }
  return static_cast<std::size_t>(i[0] + dims_[0] * (i[1] + dims_[1] * i[2]));
}

double Lattice::coordinate(int axis, std::int64_t i) const {
  return spec_.origin[axis] + static_cast<double>(first_[axis] + i) * spec_.spacing;
}

Vec3 Lattice::position(std::size_t node) const {
  const Index3 i = index(node);
  return {coordinate(0, i[0]), coordinate(1, i[1]), coordinate(2, i[2])};
}

std::size_t Lattice::free_nodes() const {
  std::size_t count = 0;
  for (const std::uint32_t mask : masks_) count += (mask & kNode) != 0;
  return count;
}

std::size_t Lattice::free_edges() const {
  std::size_t count = 0;
  for (const std::uint32_t mask : masks_) count += std::popcount(mask & ~kNode);
  return count / 2;
}

}  // namespace plan
