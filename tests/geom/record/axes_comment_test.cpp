#include "geom/record/axes_comment.h"

#include <gtest/gtest.h>

namespace geom {
namespace {

TEST(AxesComment, NamesAxesOfMaps) {
  for (const char* ned : {"# NED", "# ned", "# frame: ned", "#frame_id = NED, 10 Hz",
                          "# x north, y east, z down", "# coordinates in NED, metres"}) {
    const auto named = axes_of_comment(ned);
    ASSERT_TRUE(named) << ned;
    EXPECT_EQ(named->axes, Axes::neu) << ned;
    EXPECT_TRUE(named->downwards) << ned;
  }
  EXPECT_EQ(axes_of_comment("# axes: enu")->axes, Axes::enu);
  EXPECT_FALSE(axes_of_comment("# NEU")->downwards);
  EXPECT_EQ(axes_of_comment("# X = East, Y = North, Z = Up")->axes, Axes::enu);
}

TEST(AxesComment, NamesAxesThatNoTableMayHave) {
  for (const char* other : {"# FLU", "# frame: frd", "# from NED to ENU", "# z down",
                            "# x forward, y left, z up", "# frame: ecef", "# ENU, z down"}) {
    const auto named = axes_of_comment(other);
    ASSERT_TRUE(named) << other;
    EXPECT_FALSE(named->axes) << other;
  }
}

TEST(AxesComment, IsNothingInOtherWords) {
  for (const char* comment : {"", "#", "# flown by Ned", "# the end", "# z up", "# x,y,z",
                              "# frame: map", "# origin WGS84 52.5 13.4", "# x: 3, up to 20 m"}) {
    EXPECT_FALSE(axes_of_comment(comment)) << comment;
  }
}

}  // namespace
}  // namespace geom
