#pragma once

// Free heights and distances to obstacles that hold for whole cells of a grid.
//
// Example:
//   const geom::CellGrid2 grid{.corner = {0, 0}, .cell = 2, .columns = 5, .rows = 5};
//   const geom::FreeHeights heights = geom::free_heights(scene, grid);
//   const std::vector<double> distances = geom::distances_at(scene, grid, 1.5);
//   assert(heights.highest.size() == 25 && distances.size() == 25);

#include <cstddef>
#include <vector>

#include "geom/base/execution.h"
#include "geom/collision/collision.h"
#include "geom/shape/polygon.h"

namespace geom {

// Closed squares side by side along the map's x and y. Values stand row by row from the lowest y,
// in a row from the lowest x.
struct CellGrid2 {
  Vec2 corner = Vec2::Zero();  // the lowest x and y, m
  double cell = 1;             // m, > 0
  std::size_t columns = 0;
  std::size_t rows = 0;

  // The cell of a column and row in x and y.
  Aabb box(std::size_t column, std::size_t row) const;
};

// For each cell the highest stretch of heights, m, in which the reference point is free anywhere in
// the cell, with vehicle and margin: within the bounds, and off every grown box, whatever its
// times. Closed; NaN where there is none. Sound: free heights may be left out by rounding, never
// added.
struct FreeHeights {
  std::vector<double> lowest;
  std::vector<double> highest;
};
FreeHeights free_heights(const CollisionScene& scene, const CellGrid2& grid,
                         const Execution& run = {});

// For each cell a distance, m, that no obstacle, grown by the vehicle without the margin, is nearer
// to any place of the cell at height `z`; 0 where one reaches the cell. Rounded down. NaN where the
// cell is not whole inside the bounds, or no obstacle is there at all.
std::vector<double> distances_at(const CollisionScene& scene, const CellGrid2& grid, double z,
                                 const Execution& run = {});

}  // namespace geom
