#pragma once

// Numbers on a grid of a map, as GIS programs have them: north up, from the north-west on.
//
// Example:
//   const geom::CellGrid2 cells{.cell = 5, .columns = 2, .rows = 1};
//   const std::vector<double> values{3.5, 4};
//   geom::gis::NumberGrid grid = geom::gis::number_grid(cells, geom::Axes::enu);
//   grid.bands.push_back({"clearance", "m to the nearest obstacle",
//                         geom::gis::from_north(cells, geom::Axes::enu, values)});
//   assert(grid.columns == 2 && grid.bands[0].values[1] == 4);

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "geom/collision/height_grid.h"
#include "geom/map/frame.h"
#include "geom/shape/polygon.h"

namespace geom::gis {

struct NumberBand {
  std::string name;
  std::string what;            // a sentence that stands in the file
  std::vector<double> values;  // row by row from the north, west first; NaN: none
};

// Cells of one size, in metres east and north of the map's origin.
struct NumberGrid {
  std::size_t columns = 0;
  std::size_t rows = 0;
  double cell = 1;
  Vec2 corner = Vec2::Zero();  // the outer corner in the south-west: east, north
  std::vector<NumberBand> bands;
};

// The cells of a grid along the axes of a map, without bands.
NumberGrid number_grid(const CellGrid2& grid, geom::Axes axes);

// Puts the values of a grid's cells into the order of a NumberBand. Precondition: each cell has
// one.
std::vector<double> from_north(const CellGrid2& grid, geom::Axes axes,
                               std::span<const double> values);

}  // namespace geom::gis
