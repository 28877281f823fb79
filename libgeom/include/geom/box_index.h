#pragma once

// Which boxes are near: a hash of square cells in plan, for algorithms on tables of boxes.

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "geom/aabb.h"

namespace geom {

// Refers to boxes by their index; they may change as long as those asked for were added.
class BoxIndex {
 public:
  // `cell`: metres, about the size of a box and its surroundings.
  explicit BoxIndex(double cell) : cell_(cell) {}

  void add(std::size_t i, const Aabb& box);

  // Indices, ascending, of boxes added whose cells the region touches: all that meet it, and more.
  std::vector<std::size_t> near(const Aabb& region) const;

 private:
  struct Cells {
    std::int64_t x0, x1, y0, y1;
    std::int64_t count() const { return (x1 - x0 + 1) * (y1 - y0 + 1); }
  };
  static constexpr std::int64_t kMany = 256;  // a box over more cells is looked at every time

  Cells cells(const Aabb& box) const;

  double cell_;
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> hash_;
  std::vector<std::size_t> large_;
};

// A cell size for a table: the mean side of its boxes in plan, at least 1 m.
double index_cell(std::span<const Aabb> boxes);

}  // namespace geom
