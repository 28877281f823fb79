#include "geom/map/detail_levels.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "geom/map/far_blocks.h"

namespace geom {
namespace {

constexpr std::size_t kATile = 600;   // boxes, about
constexpr double kFinest = 1.0 / 96;  // the cell of the finest blocks, of a tile
constexpr double kCoarser = 2.2;      // from each level to the next
constexpr double kFewer = 0.8;        // a level has so many of the blocks before it, at most

struct Tiling {
  Vec3 corner;
  double side;  // metres

  std::pair<double, double> tile(const Aabb& box) const {
    const Vec3 at = (0.5 * (box.min + box.max) - corner) / side;
    return {std::floor(at.y()), std::floor(at.x())};
  }
};

Tiling tiling_of(std::span<const Aabb> boxes) {
  Aabb around = boxes.front();
  for (const Aabb& box : boxes) {
    around = {around.min.cwiseMin(box.min), around.max.cwiseMax(box.max)};
  }
  const Vec3 size = around.max - around.min;
  const double tiles = std::max(1.0, static_cast<double>(boxes.size()) / kATile);
  const double side =
      std::max(std::sqrt(size.x() * size.y() / tiles), size.head<2>().maxCoeff() / tiles);
  return {around.min, std::max(side, 1e-3)};
}

// Boxes and their groups, in the order of their tiles.
struct InTiles {
  std::vector<Aabb> boxes;
  std::vector<std::uint32_t> group;
  std::vector<std::uint32_t> first;
};

FarLevel far_level(const InTiles& tiles, double cell) {
  FarLevel out{cell, {}, {}, {}};
  for (std::size_t t = 0; t + 1 < tiles.first.size(); ++t) {
    out.first.push_back(static_cast<std::uint32_t>(out.blocks.size()));
    for (std::uint32_t i = tiles.first[t]; i < tiles.first[t + 1];) {
      std::uint32_t end = i + 1;
      while (end < tiles.first[t + 1] && tiles.group[end] == tiles.group[i]) ++end;
      for (const Aabb& block : far_blocks(std::span(tiles.boxes).subspan(i, end - i), cell)) {
        out.blocks.push_back(block);
        out.of.push_back(i);
      }
      i = end;
    }
  }
  out.first.push_back(static_cast<std::uint32_t>(out.blocks.size()));
  return out;
}

}  // namespace

DetailLevels detail_levels(std::span<const Aabb> boxes, std::span<const std::uint32_t> group) {
  const Tiling tiling = tiling_of(boxes);
  DetailLevels out;
  const auto key = [&](std::uint32_t i) { return std::tuple(tiling.tile(boxes[i]), group[i], i); };
  out.order.resize(boxes.size());
  std::iota(out.order.begin(), out.order.end(), 0u);
  std::sort(out.order.begin(), out.order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  InTiles tiles;
  for (const std::uint32_t i : out.order) {
    if (tiles.boxes.empty() || tiling.tile(boxes[i]) != tiling.tile(tiles.boxes.back())) {
      tiles.first.push_back(static_cast<std::uint32_t>(tiles.boxes.size()));
    }
    tiles.boxes.push_back(boxes[i]);
    tiles.group.push_back(group[i]);
  }
  tiles.first.push_back(static_cast<std::uint32_t>(boxes.size()));
  for (double cell = tiling.side * kFinest; cell < tiling.side; cell *= kCoarser) {
    FarLevel level = far_level(tiles, cell);
    const double most =
        out.far.empty() ? 1e300 : kFewer * static_cast<double>(out.far.back().blocks.size());
    if (static_cast<double>(level.blocks.size()) > most) break;
    out.far.push_back(std::move(level));
  }
  out.first = std::move(tiles.first);
  return out;
}

}  // namespace geom
