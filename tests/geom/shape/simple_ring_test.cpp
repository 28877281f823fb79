#include "shape/simple_ring.h"

#include <gtest/gtest.h>

namespace geom {
namespace {

TEST(IsSimple, HasNoEdgesThatCrossOrTouch) {
  EXPECT_TRUE(is_simple(std::vector<Vec2>{{0, 0}, {4, 0}, {4, 4}, {0, 4}}));
  EXPECT_TRUE(is_simple(std::vector<Vec2>{{0, 4}, {4, 4}, {4, 0}, {0, 0}}));
  EXPECT_FALSE(is_simple(std::vector<Vec2>{{0, 0}, {4, 4}, {4, 0}, {0, 4}}));
  EXPECT_FALSE(is_simple(std::vector<Vec2>{{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}));
  EXPECT_FALSE(is_simple(std::vector<Vec2>{{0, 0}, {4, 0}, {4, 0}, {0, 4}}));
  EXPECT_FALSE(is_simple(std::vector<Vec2>{{0, 0}, {4, 0}}));
}

}  // namespace
}  // namespace geom
