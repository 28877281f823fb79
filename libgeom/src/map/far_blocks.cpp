#include "geom/map/far_blocks.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>

namespace geom {
namespace {

// What a rectangle of squares of the grid holds; `low` and `high` are the lowest top and the
// highest bottom of its squares.
struct Block {
  std::int64_t row = 0;
  std::int64_t column = 0;
  std::int64_t layer = 0;  // from below, in its square
  std::int64_t rows = 1;
  std::int64_t columns = 1;
  Aabb box;
  double lowest_top = 0;
  double highest_bottom = 0;
};

std::int64_t square(double x, double cell) {
  return static_cast<std::int64_t>(std::floor(x / cell));
}

// The part of a box in each square of the grid.
void cut(const Aabb& box, double cell, std::vector<Block>& out) {
  for (std::int64_t row = square(box.min.y(), cell); row <= square(box.max.y(), cell); ++row) {
    for (std::int64_t column = square(box.min.x(), cell); column <= square(box.max.x(), cell);
         ++column) {
      Aabb part = box;
      const auto clip = [&](int axis, std::int64_t at) {
        part.min[axis] = std::max(part.min[axis], static_cast<double>(at) * cell);
        part.max[axis] = std::min(part.max[axis], static_cast<double>(at + 1) * cell);
        part.max[axis] = std::max(part.max[axis], part.min[axis]);
      };
      clip(0, column);
      clip(1, row);
      out.push_back({.row = row, .column = column, .box = part});
    }
  }
}

Aabb around(const Aabb& a, const Aabb& b) { return {a.min.cwiseMin(b.min), a.max.cwiseMax(b.max)}; }

// In each square one block where the parts are less than a cell above one another.
std::vector<Block> stacked(std::vector<Block> parts, double cell) {
  std::sort(parts.begin(), parts.end(), [](const Block& a, const Block& b) {
    return std::tuple(a.row, a.column, a.box.min.z()) < std::tuple(b.row, b.column, b.box.min.z());
  });
  std::vector<Block> out;
  for (Block& part : parts) {
    const bool same =
        !out.empty() && out.back().row == part.row && out.back().column == part.column;
    if (same && part.box.min.z() < out.back().box.max.z() + cell) {
      out.back().box = around(out.back().box, part.box);
    } else {
      part.layer = same ? out.back().layer + 1 : 0;
      out.push_back(part);
    }
  }
  for (Block& block : out) {
    block.lowest_top = block.box.max.z();
    block.highest_bottom = block.box.min.z();
  }
  return out;
}

// Whether both together are level to half a cell.
bool level(const Block& a, const Block& b, double cell) {
  const Aabb both = around(a.box, b.box);
  return both.max.z() - std::min(a.lowest_top, b.lowest_top) <= 0.5 * cell &&
         std::max(a.highest_bottom, b.highest_bottom) - both.min.z() <= 0.5 * cell;
}

Block joined(const Block& a, const Block& b) {
  Block out = a;
  out.box = around(a.box, b.box);
  out.lowest_top = std::min(a.lowest_top, b.lowest_top);
  out.highest_bottom = std::max(a.highest_bottom, b.highest_bottom);
  return out;
}

std::vector<Block> joined_along_rows(std::vector<Block> blocks, double cell) {
  std::sort(blocks.begin(), blocks.end(), [](const Block& a, const Block& b) {
    return std::tuple(a.row, a.layer, a.column) < std::tuple(b.row, b.layer, b.column);
  });
  std::vector<Block> out;
  for (const Block& block : blocks) {
    Block* last = out.empty() ? nullptr : &out.back();
    if (last && last->row == block.row && last->layer == block.layer &&
        last->column + last->columns == block.column && level(*last, block, cell)) {
      *last = joined(*last, block);
      ++last->columns;
    } else {
      out.push_back(block);
    }
  }
  return out;
}

std::vector<Block> joined_across_rows(std::vector<Block> blocks, double cell) {
  std::sort(blocks.begin(), blocks.end(), [](const Block& a, const Block& b) {
    return std::tuple(a.column, a.columns, a.layer, a.row) <
           std::tuple(b.column, b.columns, b.layer, b.row);
  });
  std::vector<Block> out;
  for (const Block& block : blocks) {
    Block* last = out.empty() ? nullptr : &out.back();
    if (last && last->column == block.column && last->columns == block.columns &&
        last->layer == block.layer && last->row + last->rows == block.row &&
        level(*last, block, cell)) {
      *last = joined(*last, block);
      ++last->rows;
    } else {
      out.push_back(block);
    }
  }
  return out;
}

}  // namespace

std::vector<Aabb> far_blocks(std::span<const Aabb> boxes, double cell) {
  std::vector<Aabb> out;
  std::vector<Block> parts;
  for (const Aabb& box : boxes) {
    if ((box.max - box.min).head<2>().minCoeff() >= 2 * cell) {
      out.push_back(box);
    } else {
      cut(box, cell, parts);
    }
  }
  const std::vector<Block> rows = joined_along_rows(stacked(std::move(parts), cell), cell);
  for (const Block& block : joined_across_rows(rows, cell)) out.push_back(block.box);
  return out;
}

}  // namespace geom
