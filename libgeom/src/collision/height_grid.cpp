#include "geom/collision/height_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geom/base/parallel.h"

namespace geom {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

double below(double v) { return std::nextafter(v, -std::numeric_limits<double>::infinity()); }
double above(double v) { return std::nextafter(v, std::numeric_limits<double>::infinity()); }

struct Stretch {
  double low = kNone;
  double high = kNone;
};

// The highest gap between these closed stretches within the bounds; both ends are free.
Stretch highest_gap(std::vector<Stretch> taken, double low, double high) {
  std::sort(taken.begin(), taken.end(),
            [](const auto& a, const auto& b) { return a.high > b.high; });
  double top = high;
  for (const Stretch& one : taken) {
    if (one.low > top) continue;
    if (one.high < top) return {above(one.high), top};
    top = below(one.low);
    if (top < low) return {};
  }
  return top >= low ? Stretch{low, top} : Stretch{};
}

bool inside(const Aabb& cell, const Aabb& bounds) {
  return (cell.min.head<2>().array() >= bounds.min.head<2>().array()).all() &&
         (cell.max.head<2>().array() <= bounds.max.head<2>().array()).all();
}

}  // namespace

Aabb CellGrid2::box(std::size_t column, std::size_t row) const {
  const auto edge = [&](double from, std::size_t i) {
    return from + cell * static_cast<double>(i);
  };
  return {{edge(corner.x(), column), edge(corner.y(), row), 0},
          {edge(corner.x(), column + 1), edge(corner.y(), row + 1), 0}};
}

FreeHeights free_heights(const CollisionScene& scene, const CellGrid2& grid, const Execution& run) {
  FreeHeights out;
  out.lowest.assign(grid.columns * grid.rows, kNone);
  out.highest = out.lowest;
  const auto& bounds = scene.free_bounds();
  if (!bounds) return out;
  parallel_for(grid.rows, run, [&](std::size_t row) {
    for (std::size_t column = 0; column < grid.columns; ++column) {
      Aabb cell = grid.box(column, row);
      if (!inside(cell, *bounds)) continue;
      cell.min.z() = bounds->min.z();
      cell.max.z() = bounds->max.z();
      std::vector<Stretch> taken;
      for (const std::size_t i : scene.boxes_meeting(cell)) {
        const Aabb grown = scene.grown(i);
        taken.push_back({grown.min.z(), grown.max.z()});
      }
      const Stretch gap = highest_gap(std::move(taken), bounds->min.z(), bounds->max.z());
      out.lowest[row * grid.columns + column] = gap.low;
      out.highest[row * grid.columns + column] = gap.high;
    }
  });
  return out;
}

std::vector<double> distances_at(const CollisionScene& scene, const CellGrid2& grid, double z,
                                 const Execution& run) {
  std::vector<double> out(grid.columns * grid.rows, kNone);
  const auto& bounds = scene.free_bounds();
  if (!bounds || z < bounds->min.z() || z > bounds->max.z()) return out;
  // The distance from a cell to a box is that from its middle to the box grown by half the cell.
  // More by 1e-9 m and a few ulp: by what the cell's edges and its middle round.
  const double half = grid.cell / 2;
  const double reach =
      std::max(bounds->min.cwiseAbs().maxCoeff(), bounds->max.cwiseAbs().maxCoeff());
  const double rounding = 1e-9 + 8 * std::numeric_limits<double>::epsilon() * reach;
  Vehicle wide = scene.vehicle();
  wide.half += Vec3(half + rounding, half + rounding, 0);
  const CollisionScene cells(scene.map(), wide, 0);
  parallel_for(grid.rows, run, [&](std::size_t row) {
    for (std::size_t column = 0; column < grid.columns; ++column) {
      const Aabb cell = grid.box(column, row);
      if (!inside(cell, *bounds)) continue;
      const Vec3 middle(cell.min.x() + half, cell.min.y() + half, z);
      const auto nearest = cells.nearest(middle, std::numeric_limits<double>::infinity());
      if (!nearest) continue;
      out[row * grid.columns + column] = std::max(0.0, nearest->distance * (1 - 1e-12) - rounding);
    }
  });
  return out;
}

}  // namespace geom
