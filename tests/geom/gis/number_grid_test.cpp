#include "geom/gis/number_grid.h"

#include <gtest/gtest.h>

namespace geom::gis {
namespace {

// Three cells along x and two along y; each value is 10 times the cell along y, plus that along x.
const CellGrid2 kCells{.corner = {100, 200}, .cell = 5, .columns = 3, .rows = 2};
const std::vector<double> kValues{0, 1, 2, 10, 11, 12};

TEST(NumberGrid, OfEastNorthAxesHasTheNorthernRowFirst) {
  const NumberGrid grid = number_grid(kCells, geom::Axes::enu);
  EXPECT_EQ(grid.columns, 3u);
  EXPECT_EQ(grid.rows, 2u);
  EXPECT_EQ(grid.corner, Vec2(100, 200));
  EXPECT_EQ(from_north(kCells, geom::Axes::enu, kValues),
            (std::vector<double>{10, 11, 12, 0, 1, 2}));
}

TEST(NumberGrid, OfNorthEastAxesIsTurned) {
  const NumberGrid grid = number_grid(kCells, geom::Axes::neu);
  EXPECT_EQ(grid.columns, 2u);
  EXPECT_EQ(grid.rows, 3u);
  EXPECT_EQ(grid.corner, Vec2(200, 100));
  EXPECT_EQ(from_north(kCells, geom::Axes::neu, kValues),
            (std::vector<double>{2, 12, 1, 11, 0, 10}));
}

}  // namespace
}  // namespace geom::gis
