#include "together/box_tree.h"

#include <gtest/gtest.h>

#include <cmath>

namespace traj {
namespace {

TEST(BoxTree, CountsTouchingAsMeeting) {
  TimedBox a;
  TimedBox b;
  a.high = {1, 1, 1, 1};
  b.low = {1, 0, 0, 1};
  b.high = {2, 1, 1, 2};
  EXPECT_TRUE(meet(a, b));
  b.low[3] = std::nextafter(1.0, 2.0);
  EXPECT_FALSE(meet(a, b));
}

}  // namespace
}  // namespace traj
