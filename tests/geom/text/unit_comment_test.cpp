#include "text/unit_comment.h"

#include <gtest/gtest.h>

namespace geom {
namespace {

TEST(UnitOfComment, IsTheLengthThatItNames) {
  EXPECT_EQ(unit_of_comment("# File units = inches"), 0.0254);
  EXPECT_EQ(unit_of_comment("#File units = millimeters\r"), 1e-3);
  EXPECT_EQ(unit_of_comment("# Units: meters"), 1);
  EXPECT_EQ(unit_of_comment("part UNITS=mm"), 1e-3);
  EXPECT_EQ(unit_of_comment("unit :ft, y up"), 0.3048);
}

TEST(UnitOfComment, IsNothingInOtherWords) {
  for (const char* comment : {"", "# a unit cube", "# units", "# units =", "# units are metres",
                              "# units = cubits", "# community: meters"}) {
    EXPECT_FALSE(unit_of_comment(comment)) << comment;
  }
}

}  // namespace
}  // namespace geom
