#include "bound/level.h"

#include <gtest/gtest.h>

namespace plan {
namespace {

TEST(Level, APathLeavesToTheOtherSide) {
  const EdgePart edge{{5, 1, 0}, {5, 1, 4}, 2, {1, -1}};
  EXPECT_TRUE(leaves(edge, 0, 2));
  EXPECT_FALSE(leaves(edge, 0, 1));
  EXPECT_TRUE(leaves(edge, 1, 1));
  EXPECT_TRUE(leaves({{5, 2, 0}, {5, 2, 0}, kCorner, {}}, 0, 3));
}

}  // namespace
}  // namespace plan
