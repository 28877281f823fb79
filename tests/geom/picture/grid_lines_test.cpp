// The grid on the ground.

#include "geom/picture/grid_lines.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace {

TEST(RoundLength, IsOneTwoOrFiveTimesAPowerOfTen) {
  const std::vector<std::pair<double, double>> cases = {{1, 1}, {1.9, 1},     {2, 2},      {4.9, 2},
                                                        {5, 5}, {999.9, 500}, {1000, 1000}};
  for (const auto& [length, round] : cases) {
    EXPECT_NEAR(geom::picture::round_length(length), round, 1e-9) << length;
  }
  EXPECT_NEAR(geom::picture::round_length(0.05), 0.05, 1e-12);
}

TEST(GridLines, HasSixToFifteenCellsOnAnyMap) {
  for (double side = 3.5; side < 20000; side *= 1.17) {
    const auto grid = geom::picture::grid_lines({{0, 0, 0}, {side, side / 3, 10}});
    EXPECT_GE(side / grid.cell, 6 - 1e-9) << side;
    EXPECT_LE(side / grid.cell, 15 + 1e-9) << side;
    EXPECT_DOUBLE_EQ(grid.fine, grid.cell / 10);
  }
}

}  // namespace
