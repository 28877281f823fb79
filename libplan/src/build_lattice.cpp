#include "plan/build_lattice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geom/error.h"
#include "geom/parallel.h"

namespace plan {
namespace {

using geom::Aabb;

struct Range {  // of node indices along an axis, half open
  std::int64_t begin = 0;
  std::int64_t end = 0;
};

// The grid that a lattice stands on: sorted coordinates along each axis.
struct Grid {
  LatticeSpec spec;
  Index3 first{};
  Index3 dims{};
  std::array<std::vector<double>, 3> at;

  std::size_t node(std::int64_t i, std::int64_t j, std::int64_t k) const {
    return static_cast<std::size_t>(i + dims[0] * (j + dims[1] * k));
  }
  Vec3 position(std::int64_t i, std::int64_t j, std::int64_t k) const {
    return {at[0][i], at[1][j], at[2][k]};
  }
  // Nodes whose coordinate lies in the closed interval.
  Range inside(int axis, double low, double high) const {
    const auto& x = at[axis];
    return {std::lower_bound(x.begin(), x.end(), low) - x.begin(),
            std::upper_bound(x.begin(), x.end(), high) - x.begin()};
  }
};

Grid make_grid(const geom::CollisionScene& scene, const LatticeSpec& spec,
               const std::optional<Aabb>& within) {
  Grid grid{spec, {}, {}, {}};
  const std::string where = fmt::format("lattice of {} m", spec.spacing);
  if (!scene.free_bounds())
    throw geom::InputError(where, "the vehicle does not fit into the bounds");
  Aabb inner = *scene.free_bounds();
  if (within) inner = {inner.min.cwiseMax(within->min), inner.max.cwiseMin(within->max)};
  double total = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const auto coordinate = [&](double k) { return spec.origin[axis] + k * spec.spacing; };
    const double furthest = std::max(std::abs(inner.min[axis] - spec.origin[axis]),
                                     std::abs(inner.max[axis] - spec.origin[axis]));
    if (!(furthest / spec.spacing < 0x1p52)) {  // beyond, k + 1 may be k
      throw geom::InputError(where, "expected node indices below 2^52: use a larger spacing");
    }
    double k = std::floor((inner.min[axis] - spec.origin[axis]) / spec.spacing) - 1;
    while (coordinate(k) < inner.min[axis]) ++k;
    grid.first[axis] = static_cast<std::int64_t>(k);
    total *= std::max(0.0, (inner.max[axis] - coordinate(k)) / spec.spacing + 1);
    if (total > 2147483648.0) {
      throw geom::InputError(where, "expected at most 2^31 nodes: use a larger spacing");
    }
    for (; coordinate(k) <= inner.max[axis]; ++k) grid.at[axis].push_back(coordinate(k));
    grid.dims[axis] = static_cast<std::int64_t>(grid.at[axis].size());
    if (grid.dims[axis] == 0) throw geom::InputError(where, "no node lies inside the bounds");
  }
  return grid;
}

// Start nodes of the edges of one direction whose extent along an axis meets the interval.
Range starts(const Grid& grid, int axis, int step, double low, double high) {
  Range r = grid.inside(axis, low, high);
  const std::int64_t n = grid.dims[axis];
  // An edge without extent here must start inside; one with extent may also straddle the interval.
  if (step > 0) {
    r.begin = std::max<std::int64_t>(r.begin - 1, 0);
    r.end = std::min(r.end, n - 1);
  } else if (step < 0) {
    r.begin = std::max<std::int64_t>(r.begin, 1);
    r.end = std::min(r.end + 1, n);
  }
  return r;
}

// One layer of nodes and the edges that start in it.
class Layer {
 public:
  Layer(const Grid& grid, int directions, std::int64_t k, std::vector<std::uint32_t>& masks)
      : grid_(grid), directions_(directions), k_(k), masks_(masks) {}

  void fill() {
    for (std::int64_t j = 0; j < grid_.dims[1]; ++j) {
      for (std::int64_t i = 0; i < grid_.dims[0]; ++i) {
        std::uint32_t mask = Lattice::kNode;
        for (int d = 0; d < directions_; ++d) mask |= exists(i, j, d) ? 1u << d : 0;
        masks_[grid_.node(i, j, k_)] = mask;
      }
    }
  }

  void block(const Aabb& box) {
    const auto& z = grid_.at[2];
    const bool at_level = z[k_] >= box.min.z() && z[k_] <= box.max.z();
    const bool above = k_ + 1 < grid_.dims[2] && z[k_ + 1] >= box.min.z() && z[k_] <= box.max.z();
    const bool below = k_ > 0 && z[k_] >= box.min.z() && z[k_ - 1] <= box.max.z();
    if (!at_level && !above && !below) return;
    if (at_level) block_nodes(box);
    for (int d = 0; d < directions_; ++d) {
      const int dz = kDirection[d][2];
      if (dz == 0 ? at_level : dz > 0 ? above : below) block_edges(box, d);
    }
  }

 private:
  bool exists(std::int64_t i, std::int64_t j, int d) const {
    const auto& [dx, dy, dz] = kDirection[d];
    const auto in = [](std::int64_t v, std::int64_t n) { return v >= 0 && v < n; };
    return in(i + dx, grid_.dims[0]) && in(j + dy, grid_.dims[1]) && in(k_ + dz, grid_.dims[2]);
  }

  void block_nodes(const Aabb& box) {
    const Range x = grid_.inside(0, box.min.x(), box.max.x());
    const Range y = grid_.inside(1, box.min.y(), box.max.y());
    for (std::int64_t j = y.begin; j < y.end; ++j) {
      for (std::int64_t i = x.begin; i < x.end; ++i) {
        masks_[grid_.node(i, j, k_)] &= ~Lattice::kNode;
      }
    }
  }

  void block_edges(const Aabb& box, int d) {
    const auto& [dx, dy, dz] = kDirection[d];
    const Range x = starts(grid_, 0, dx, box.min.x(), box.max.x());
    const Range y = starts(grid_, 1, dy, box.min.y(), box.max.y());
    const bool straight = d < 3;  // its box is itself: overlap decides
    for (std::int64_t j = y.begin; j < y.end; ++j) {
      for (std::int64_t i = x.begin; i < x.end; ++i) {
        std::uint32_t& mask = masks_[grid_.node(i, j, k_)];
        if (!(mask & 1u << d)) continue;
        if (straight || geom::segment_hits(grid_.position(i, j, k_),
                                           grid_.position(i + dx, j + dy, k_ + dz), box)) {
          mask &= ~(1u << d);
        }
      }
    }
  }

  const Grid& grid_;
  int directions_;
  std::int64_t k_;
  std::vector<std::uint32_t>& masks_;
};

// Gives every node the opposite bits of the edges that end in it.
void mirror_layer(const Grid& grid, int directions, std::int64_t k,
                  std::vector<std::uint32_t>& masks) {
  for (std::int64_t j = 0; j < grid.dims[1]; ++j) {
    for (std::int64_t i = 0; i < grid.dims[0]; ++i) {
      std::uint32_t opposite = 0;
      for (int d = 0; d < directions; ++d) {
        const std::int64_t a = i - kDirection[d][0];
        const std::int64_t b = j - kDirection[d][1];
        const std::int64_t c = k - kDirection[d][2];
        if (a < 0 || b < 0 || c < 0 || a >= grid.dims[0] || b >= grid.dims[1] ||
            c >= grid.dims[2]) {
          continue;
        }
        // Bits below kHalfDirections are final by now, and this pass leaves them alone.
        if (masks[grid.node(a, b, c)] & 1u << d) opposite |= 1u << (kHalfDirections + d);
      }
      masks[grid.node(i, j, k)] |= opposite;
    }
  }
}

std::vector<Aabb> grown_boxes(const geom::CollisionScene& scene,
                              const std::optional<Aabb>& within) {
  std::vector<Aabb> boxes;
  if (within) {
    for (const std::size_t i : scene.boxes_meeting(*within)) boxes.push_back(scene.grown(i));
    return boxes;
  }
  boxes.reserve(scene.map().size());
  for (const Aabb& box : scene.map().boxes()) boxes.push_back(geom::grow(box, scene.half()));
  return boxes;
}

}  // namespace

Lattice build_lattice(const geom::CollisionScene& scene, const LatticeSpec& spec,
                      const geom::Execution& run, const std::optional<Aabb>& within) {
  const Grid grid = make_grid(scene, spec, within);
  const int directions = half_directions(spec.connectivity);
  std::vector<std::uint32_t> masks(
      static_cast<std::size_t>(grid.dims[0] * grid.dims[1] * grid.dims[2]));
  const std::vector<Aabb> boxes = grown_boxes(scene, within);

  const auto layers = static_cast<std::size_t>(grid.dims[2]);
  geom::parallel_for(layers, run, [&](std::size_t k) {
    Layer layer(grid, directions, static_cast<std::int64_t>(k), masks);
    layer.fill();
    for (const Aabb& box : boxes) layer.block(box);
  });
  // Neighbouring layers read each other's lower bits while writing upper ones, so this is serial.
  for (std::int64_t k = 0; k < grid.dims[2]; ++k) mirror_layer(grid, directions, k, masks);
  const geom::Provenance made_for{scene.map().hash(), scene.map().spec().frame.axes,
                                  scene.vehicle(), scene.margin()};
  return Lattice(spec, grid.first, grid.dims, made_for, std::move(masks));
}

}  // namespace plan
