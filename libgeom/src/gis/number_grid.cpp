#include "geom/gis/number_grid.h"

namespace geom::gis {

NumberGrid number_grid(const CellGrid2& grid, geom::Axes axes) {
  const bool enu = axes == geom::Axes::enu;
  return {.columns = enu ? grid.columns : grid.rows,
          .rows = enu ? grid.rows : grid.columns,
          .cell = grid.cell,
          .corner = enu ? grid.corner : Vec2(grid.corner.y(), grid.corner.x()),
          .bands = {}};
}

std::vector<double> from_north(const CellGrid2& grid, geom::Axes axes,
                               std::span<const double> values) {
  const NumberGrid turned = number_grid(grid, axes);
  const bool enu = axes == geom::Axes::enu;
  std::vector<double> out;
  out.reserve(values.size());
  for (std::size_t i = 0; i < turned.rows; ++i) {
    const std::size_t north = turned.rows - 1 - i;
    for (std::size_t east = 0; east < turned.columns; ++east) {
      out.push_back(values[enu ? north * grid.columns + east : east * grid.columns + north]);
    }
  }
  return out;
}

}  // namespace geom::gis
