#pragma once

// The ground of a laser scan, told from what stands on it.
//
// Example:
//   geom::GroundGrid grid({.cell = 2});
//   std::vector<geom::Vec3> points;
//   for (int x = 0; x < 100; ++x) {
//     for (int y = 0; y < 100; ++y) points.emplace_back(x, y, std::max(x, y) < 30 ? 8 : 0);
//   }
//   for (const geom::Vec3& p : points) grid.add(p);
//   grid.finish();
//   assert(grid.is_ground({60, 60, 0}) && !grid.is_ground({10, 10, 8}));  // a roof

#include <memory>

#include "geom/base/vec3.h"

namespace geom {

struct GroundSpec {
  double cell = 2;      // metres
  double slope = 0.1;   // metres up a metre aside: what rises faster is no ground
  double height = 0.3;  // metres above the ground of a cell, sloped as to its neighbours
  double step = 1;      // metres, on top of the slope, from the ground of a cell to the next
  double widest = 200;  // metres: no roof is wider without something lower beside it
};

// A point is ground if it passes both of two tests. So each test can only turn into obstacles what
// the other takes for ground:
// - It is near the lowest returns around it, lowered to what the slope allows (K. Zhang et al.,
//   "A progressive morphological filter", TGRS 41(4), 2003, with a slope instead of windows).
//   Alone that takes the middle of a wide flat roof for ground.
// - Its cell was grown from a seed, from cell to cell, until a step or a place narrower than two
//   cells. Seeds are what is lowest within `widest`, and what covers the square of that; 100 m2 of
//   joined cells or more. What grew so, and stands above what is beside it along more than a fifth
//   of its edge, is a roof, and no ground either.
// What no seed reaches, such as a courtyard, is not ground.
//
// Add all points, finish(), then ask; time and memory grow with the cells. InputError where a size
// is not > 0 or another number < 0, and where indices of cells do not fit 31 bits.
class GroundGrid {
 public:
  explicit GroundGrid(const GroundSpec& spec);
  ~GroundGrid();
  GroundGrid(GroundGrid&&) noexcept;

  void add(const Vec3& p);
  void finish();
  bool is_ground(const Vec3& p) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace geom
