#include "geom/base/percentile.h"

#include <gtest/gtest.h>

namespace geom {
namespace {

TEST(Percentile, IsByNearestRank) {
  EXPECT_EQ(percentile({3, 1, 2}, 0.5), 2);
  EXPECT_EQ(percentile({4, 3, 1, 2}, 0.5), 2);
  EXPECT_EQ(percentile({1, 2}, 0.99), 2);
  EXPECT_EQ(percentile({7}, 0.01), 7);
  EXPECT_EQ(percentile({5, 1, 4, 2, 3}, 0.2), 1);
  EXPECT_EQ(percentile({5, 1, 4, 2, 3}, 0.21), 2);
  EXPECT_EQ(percentile({5, 1, 4, 2, 3}, 0.999), 5);
  EXPECT_EQ(percentile({5, 1, 4, 2, 3}, 1), 5);
}

}  // namespace
}  // namespace geom
