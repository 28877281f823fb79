#include "map/cell_index.h"

#include <gtest/gtest.h>

#include "support/random_city.h"

namespace geom {
namespace {

TEST(CellIndex, HoldsTheCoordinateAsDoublesMultiply) {
  support::Random random(9);
  for (int i = 0; i < 100000; ++i) {
    const double size = random.uniform(0.05, 3);
    const double v = random.below(2) ? random.stepped(-1e4, 1e4, size) : random.uniform(-1e6, 1e6);
    const auto low = floor_index(v, size);
    ASSERT_TRUE(low * size <= v && v < (low + 1) * size) << i;
    const auto high = ceil_index(v, size);
    ASSERT_TRUE((high - 1) * size < v && v <= high * size) << i;
  }
}

TEST(CellIndex, RefusesWhatThirtyOneBitsDoNotHold) {
  EXPECT_EQ(floor_index(-0x1p30, 1), -(1 << 30));
  EXPECT_THROW(floor_index(0x1p31, 1), InputError);
  EXPECT_THROW(ceil_index(-0x1p31, 1), InputError);
  EXPECT_THROW(require_size("cell", 0), InputError);
}

}  // namespace
}  // namespace geom
