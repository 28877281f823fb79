#include "roadmap/curve.h"

#include <gtest/gtest.h>

namespace plan {
namespace {

TEST(Curve, GoesThroughEachEighthOfTheCubeBeforeTheNext) {
  const Curve curve({{0, 0, 0}, {8, 8, 8}});
  EXPECT_EQ(curve.place({0, 0, 0}), 0u);
  EXPECT_EQ(curve.place({-5, 0, 0}), 0u);
  EXPECT_EQ(curve.place({9, 9, 9}), curve.place({8, 8, 8}));
  EXPECT_LT(curve.place({3.9, 3.9, 3.9}), curve.place({4.1, 0, 0}));
  EXPECT_LT(curve.place({7.9, 0, 0}), curve.place({0, 4.1, 0}));
  EXPECT_LT(curve.place({7.9, 7.9, 3.9}), curve.place({0, 0, 4.1}));
}

TEST(Curve, OfAPointHasOnePlace) {
  const Curve curve({{1, 1, 1}, {1, 1, 1}});
  EXPECT_EQ(curve.place({1, 1, 1}), 0u);
  EXPECT_EQ(curve.place({5, 5, 5}), 0u);
}

}  // namespace
}  // namespace plan
