#include "plan/lattice/build_lattice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "block_store.h"
#include "geom/base/error.h"
#include "plan/lattice/lattice_part.h"

namespace plan {
namespace {

using geom::Aabb;

constexpr double kMostNodes = 0x1p40;

struct Range {  // of node indices along an axis, half open
  std::int64_t begin = 0;
  std::int64_t end = 0;
};

LatticeGrid make_grid(const geom::CollisionScene& scene, const LatticeSpec& spec,
                      const std::optional<Aabb>& within) {
  LatticeGrid grid{.spec = spec};
  const std::string where = fmt::format("lattice of {} m", spec.spacing);
  if (!scene.free_bounds())
    throw geom::InputError(where,
                           {.says = "the vehicle does not fit between the bounds of the map"});
  Aabb inner = *scene.free_bounds();
  if (within) inner = {inner.min.cwiseMax(within->min), inner.max.cwiseMin(within->max)};
  double total = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const auto coordinate = [&](double k) { return spec.origin[axis] + k * spec.spacing; };
    const double furthest = std::max(std::abs(inner.min[axis] - spec.origin[axis]),
                                     std::abs(inner.max[axis] - spec.origin[axis]));
    if (!(furthest / spec.spacing < 0x1p52)) {  // beyond, k + 1 may be k
      throw geom::InputError(
          where, {.expected = "node indices below 2^52", .advice = "use a larger spacing"});
    }
    double first = std::floor((inner.min[axis] - spec.origin[axis]) / spec.spacing) - 1;
    while (coordinate(first) < inner.min[axis]) ++first;
    double last = std::ceil((inner.max[axis] - spec.origin[axis]) / spec.spacing) + 1;
    while (coordinate(last) > inner.max[axis]) --last;
    if (last < first)
      throw geom::InputError(
          where, {.says = "no node lies inside the bounds", .advice = "use a smaller spacing"});
    grid.first[axis] = static_cast<std::int64_t>(first);
    grid.dims[axis] = static_cast<std::int64_t>(last - first) + 1;
    total *= last - first + 1;
  }
  if (total > kMostNodes) {
    throw geom::InputError(where,
                           {.expected = "at most 2^40 nodes", .advice = "use a larger spacing"});
  }
  return grid;
}

// A range of nodes and the edges that start in it.
class Stamp {
 public:
  Stamp(const LatticeGrid& grid, const Index3& low, const Index3& count, std::uint32_t* masks)
      : grid_(grid), low_(low), count_(count), masks_(masks) {
    // One node beyond on both sides, where edges that start inside end.
    for (int axis = 0; axis < 3; ++axis) {
      for (std::int64_t i = -1; i <= count[axis]; ++i) {
        at_[axis].push_back(grid.coordinate(axis, low[axis] + i));
      }
    }
  }

  Aabb region() const {
    return {{at_[0].front(), at_[1].front(), at_[2].front()},
            {at_[0].back(), at_[1].back(), at_[2].back()}};
  }

  void fill() {
    std::uint32_t* out = masks_;
    if (grid_.inside({low_[0] - 1, low_[1] - 1, low_[2] - 1},
                     {count_[0] + 2, count_[1] + 2, count_[2] + 2})) {
      std::fill_n(out, count_[0] * count_[1] * count_[2], Lattice::kNode | grid_.possible(low_));
      return;
    }
    for (std::int64_t k = 0; k < count_[2]; ++k) {
      for (std::int64_t j = 0; j < count_[1]; ++j) {
        for (std::int64_t i = 0; i < count_[0]; ++i, ++out) {
          const Index3 node = {low_[0] + i, low_[1] + j, low_[2] + k};
          *out = grid_.contains(node) ? Lattice::kNode | grid_.possible(node) : 0;
        }
      }
    }
  }

  void block(const Aabb& box) {
    for (int axis = 0; axis < 3; ++axis) {
      const auto& x = at_[axis];
      inside_[axis] = {std::lower_bound(x.begin(), x.end(), box.min[axis]) - x.begin() - 1,
                       std::upper_bound(x.begin(), x.end(), box.max[axis]) - x.begin() - 1};
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const int step : {-1, 0, 1}) starts_[axis][step + 1] = starts(axis, step);
    }
    clear({0, 0, 0}, [](std::uint32_t& mask, const Index3&) { mask &= ~Lattice::kNode; });
    const int directions = half_directions(grid_.spec.connectivity);
    for (int d = 0; d < directions; ++d) {
      const auto& step = kDirection[static_cast<std::size_t>(d)];
      const bool straight = d < 3;  // its box is itself: overlap decides
      clear(step, [&](std::uint32_t& mask, const Index3& i) {
        if (!(mask & 1u << d)) return;
        if (straight || is_inside(i, {0, 0, 0}) || is_inside(i, step) ||
            geom::segment_hits(position(i, {0, 0, 0}), position(i, step), box)) {
          mask &= ~(1u << d);
        }
      });
    }
  }

 private:
  Vec3 position(const Index3& i, const std::array<int, 3>& step) const {
    Vec3 p;
    for (std::size_t k = 0; k < 3; ++k) {
      p[static_cast<int>(k)] = at_[k][static_cast<std::size_t>(i[k] + step[k] + 1)];
    }
    return p;
  }

  // Whether the node at the end of a step is inside the box.
  bool is_inside(const Index3& i, const std::array<int, 3>& step) const {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int64_t at = i[k] + step[k];
      if (at < inside_[k].begin || at >= inside_[k].end) return false;
    }
    return true;
  }

  // Calls f(mask, node) for the nodes of the range whose edge along `step` has an extent that meets
  // the box.
  template <class F>
  void clear(const std::array<int, 3>& step, const F& f) {
    Range r[3];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      r[axis] = starts_[axis][step[axis] + 1];
      if (r[axis].begin >= r[axis].end) return;
    }
    for (std::int64_t k = r[2].begin; k < r[2].end; ++k) {
      for (std::int64_t j = r[1].begin; j < r[1].end; ++j) {
        for (std::int64_t i = r[0].begin; i < r[0].end; ++i) {
          f(masks_[i + count_[0] * (j + count_[1] * k)], Index3{i, j, k});
        }
      }
    }
  }

  // Start nodes of the edges whose extent along an axis meets the box: one without extent here must
  // start inside, one with extent may also straddle it.
  Range starts(std::size_t axis, int step) const {
    Range r = inside_[axis];
    if (step > 0) --r.begin;
    if (step < 0) ++r.end;
    return {std::max<std::int64_t>(r.begin, 0), std::min(r.end, count_[axis])};
  }

  const LatticeGrid& grid_;
  Index3 low_;
  Index3 count_;
  std::uint32_t* masks_;
  std::array<std::vector<double>, 3> at_;
  std::array<Range, 3> inside_;  // along each axis, the nodes inside the box, of all at_
  std::array<std::array<Range, 3>, 3> starts_;  // along each axis, of steps -1, 0 and 1
};

class SceneMasks final : public MaskSource {
 public:
  SceneMasks(const geom::CollisionScene& scene, const LatticeGrid& grid)
      : scene_(scene), grid_(grid) {}

  void read(const Index3& low, const Index3& count, std::uint32_t* masks) const override {
    Stamp stamp(grid_, low, count, masks);
    stamp.fill();
    for (const std::size_t i : scene_.boxes_meeting(stamp.region())) stamp.block(scene_.grown(i));
  }

 private:
  const geom::CollisionScene& scene_;
  LatticeGrid grid_;
};

}  // namespace

Lattice lazy_lattice(const geom::CollisionScene& scene, const LatticeSpec& spec,
                     const std::optional<Aabb>& within) {
  const LatticeGrid grid = make_grid(scene, spec, within);
  return Lattice(grid, geom::provenance_of(scene), std::make_shared<SceneMasks>(scene, grid));
}

LatticePart build_lattice_part(const geom::CollisionScene& scene, const LatticeSpec& spec,
                               const geom::Shard& shard, const geom::Execution& run,
                               const std::optional<Aabb>& within) {
  const Lattice lazy = lazy_lattice(scene, spec, within);
  return {lazy.grid(), lazy.made_for(), shard, store_tiles(lazy.grid(), lazy.source(), run, shard)};
}

Lattice join_lattice(std::span<const LatticePart> parts) {
  const LatticeGrid& grid = parts.front().grid;
  return Lattice(grid, parts.front().made_for, store_joined(grid, tiles_of(parts)));
}

Lattice build_lattice(const geom::CollisionScene& scene, const LatticeSpec& spec,
                      const geom::Execution& run, const std::optional<Aabb>& within) {
  const LatticePart whole = build_lattice_part(scene, spec, {}, run, within);
  return join_lattice({&whole, 1});
}

}  // namespace plan
