#include "mesh/cover_grid.h"

#include <gtest/gtest.h>

#include "support/random_city.h"

namespace geom {
namespace {

TEST(CoverGrid, KeepsWithinTheSlack) {
  for (const double largest : {0.0, 1.0, 1e8}) {
    const double slack = std::max(0.2, 1e-9 * largest);
    const CoverGrid grid = CoverGrid::of(slack, largest);
    EXPECT_GT(grid.reach, 0);
    EXPECT_LT(
        std::hypot(std::sqrt(2.0) * (grid.pitch + 2 * grid.reach), grid.rise + 2 * grid.reach),
        0.998 * slack);
  }
}

TEST(CoverGrid, FindsCellsAsItsSidesAreRounded) {
  support::Random random(1);
  for (int i = 0; i < 100000; ++i) {
    const CoverGrid grid = CoverGrid::of(random.uniform(0.1, 2), 1e8);
    const bool side = random.below(2) != 0;
    const double any = random.uniform(-1e8, 1e8);
    const double v = side ? grid.at(static_cast<long>(any / grid.pitch)) : any;
    const long from = grid.last_from(v);
    ASSERT_LE(grid.at(from), v);
    ASSERT_GT(grid.at(from + 1), v);
    const long to = grid.first_to(v);
    ASSERT_GE(grid.at(to + 1), v);
    ASSERT_LT(grid.at(to), v);
    ASSERT_EQ(to, side ? from - 1 : from);
  }
}

TEST(CoverGrid, HoldsAPointInOneCellAndARangeInAsFewAsCan) {
  const CoverGrid grid{0.5, 0.1, 1e-9};
  EXPECT_EQ(grid.around(1, 1).first, 2);
  EXPECT_EQ(grid.around(1, 1).last, 3);
  EXPECT_EQ(grid.around(1, 2).last, 4);
  EXPECT_EQ(grid.around(-0.1, 2.1).first, -1);
  EXPECT_EQ(grid.around(-0.1, 2.1).last, 5);
}

}  // namespace
}  // namespace geom
