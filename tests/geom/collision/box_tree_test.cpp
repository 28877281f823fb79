#include "collision/box_tree.h"

#include <gtest/gtest.h>

#include "geom/base/rounding.h"

namespace geom {
namespace {

TEST(TreeFrame, ReachesBeyondTheBoxes) {
  const TreeFrame frame({{10, 20, 30}, {11, 22, 33}});
  EXPECT_EQ(frame.corner, Vec3(10, 20, 30));
  EXPECT_EQ(frame.reach.min, Vec3(-990, -980, -970));
  EXPECT_EQ(frame.reach.max, Vec3(1011, 1022, 1033));
}

// Twice what the comment counts, which is 2^-21 of the largest number; and what is lost of large
// coordinates before.
TEST(TreeFrame, IsPaddedPastAllRoundings) {
  for (const double size : {0.0, 1.0, 300.0, 4e4, 1e8}) {
    for (const double corner : {0.0, -1e3, 4e6, 1e8}) {
      const Vec3 low = Vec3::Constant(corner);
      const TreeFrame frame({low, low + Vec3::Constant(size)});
      EXPECT_GE(frame.pad, std::ldexp(size + 1000, -20));
      EXPECT_GE(frame.pad, 8 * ulp(corner + size));
      EXPECT_LE(frame.pad, std::ldexp(size + 1000, -19));
    }
  }
}

}  // namespace
}  // namespace geom
