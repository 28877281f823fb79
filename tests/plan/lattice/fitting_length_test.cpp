#include "plan/lattice/fitting_length.h"

#include <gtest/gtest.h>

namespace plan {
namespace {

TEST(FittingLength, IsThatOfACityFrom300Metres) {
  EXPECT_EQ(fitting_length({{0, 0, 0}, {300, 10, 10}}, 15), 15);
  EXPECT_EQ(fitting_length({{-400, -400, 0}, {500, 500, 200}}, 25), 25);
}

TEST(FittingLength, IsTheSameShareOfTheLongestSideOfASmallerMap) {
  EXPECT_DOUBLE_EQ(fitting_length({{0, 0, 0}, {2, 8.4, 1}}, 15), 0.42);
  EXPECT_DOUBLE_EQ(fitting_length({{0, 0, 0}, {0, 0, 30}}, 10), 1);
}

TEST(FittingLength, IsThatOfACityWhereThereIsOnlyAPoint) {
  EXPECT_EQ(fitting_length({{1, 1, 1}, {1, 1, 1}}, 15), 15);
}

}  // namespace
}  // namespace plan
