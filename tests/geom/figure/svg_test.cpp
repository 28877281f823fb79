#include "geom/figure/svg.h"

#include <gtest/gtest.h>

namespace {

TEST(Frame, IsLinearWhereNothingIsShownAtLarge) {
  const geom::figure::Frame frame{10, 20, 100, 200, {-1, -300}, {1, 500}};
  for (const double y : {-300.0, -1.0, 0.0, 1.0, 100.0, 500.0}) {
    EXPECT_NEAR(frame.at({0, y}).y, 20 + 200 * (500 - y) / 800, 1e-9) << y;
  }
}

TEST(Frame, ShowsWhatIsNearAtLarge) {
  geom::figure::Frame frame{0, 0, 100, 200, {0, 0}, {1, 50}, 1};
  EXPECT_DOUBLE_EQ(frame.at({0, 0}).y, 200);
  EXPECT_DOUBLE_EQ(frame.at({0, 1}).y, 110);
  EXPECT_DOUBLE_EQ(frame.at({0, 50}).y, 0);
  frame.high.y = 0.8;  // all of it is near
  EXPECT_DOUBLE_EQ(frame.at({0, 0.4}).y, 100);
}

}  // namespace
