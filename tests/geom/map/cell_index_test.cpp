#include "map/cell_index.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "support/random_city.h"

namespace geom {
namespace {

TEST(CellIndex, HoldsTheCoordinateAsDoublesMultiply) {
  support::Random random(9);
  for (int i = 0; i < 100000; ++i) {
    const double size = random.uniform(0.05, 3);
    const double edge = (random.below(20001) - 10000) * size;
    const double v = std::array{edge, std::nextafter(edge, -1e9), std::nextafter(edge, 1e9),
                                random.uniform(-1e6, 1e6)}[i % 4];
    const CellIndex of(size);
    const auto low = of.floor(v);
    ASSERT_TRUE(low * size <= v && v < (low + 1) * size) << i;
    const auto high = of.ceil(v);
    ASSERT_TRUE((high - 1) * size < v && v <= high * size) << i;
  }
}

TEST(CellIndex, RefusesWhatThirtyOneBitsDoNotHold) {
  EXPECT_EQ(CellIndex(1).floor(-0x1p30), -(1 << 30));
  EXPECT_THROW(CellIndex(1).floor(0x1p31), InputError);
  EXPECT_THROW(CellIndex(1).ceil(-0x1p31), InputError);
  EXPECT_THROW(require_size("cell", 0), InputError);
}

}  // namespace
}  // namespace geom
