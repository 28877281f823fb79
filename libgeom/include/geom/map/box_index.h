#pragma once

// Which boxes are near: hashes of square cells in plan, for algorithms on tables of boxes.
//
// Example:
//   const std::vector<geom::Aabb> boxes = {{{0, 0, 0}, {1, 1, 1}}, {{50, 0, 0}, {51, 1, 1}}};
//   geom::BoxIndex index(geom::index_cell(boxes));
//   for (std::size_t i = 0; i < boxes.size(); ++i) index.add(i, boxes[i]);
//   const auto near = index.near({{0, 0, 0}, {0.5, 0.5, 2}});  // all that meet it, perhaps more
//   assert(near == std::vector<std::size_t>{0});

#include <cstdint>
#include <map>
#include <span>
#include <unordered_map>
#include <vector>

#include "geom/shape/aabb.h"

namespace geom {

// An index of boxes by where they are in plan; it keeps their numbers, not the boxes. There is a
// hash for each size of boxes, each size twice the one before, so that a few large boxes among many
// small ones cost no more than others.
class BoxIndex {
 public:
  // `cell`: metres, about the size of a box and its surroundings. Throws InputError unless it is
  // from 1e-6 to kLargestCoordinate. add() and near() throw InputError for a coordinate that is not
  // finite or beyond kFarthest.
  explicit BoxIndex(double cell);

  void add(std::size_t i, const Aabb& box);

  // Numbers, ascending, of all added boxes that meet the region, and perhaps of others near it.
  std::vector<std::size_t> near(const Aabb& region) const;

 private:
  struct Level {
    double cell;
    std::unordered_map<std::uint64_t, std::vector<std::size_t>> hash;
  };

  double cell_;
  std::map<int, Level>
      levels_;  // a box of level n is at most cell_ * 2^n wide: in 4 cells or fewer
};

// A cell size for a table: the mean side of its boxes in plan, at least 1 m.
double index_cell(std::span<const Aabb> boxes);

}  // namespace geom
