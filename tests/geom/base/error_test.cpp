#include "geom/base/error.h"

#include <gtest/gtest.h>

namespace geom {
namespace {

TEST(InputError, SaysSourceLineAndMessage) {
  EXPECT_STREQ(InputError("boxes.csv", 17, "no number").what(), "boxes.csv:17: no number");
  EXPECT_STREQ(InputError("city.boxmap", 0, "too short").what(), "city.boxmap: too short");
  EXPECT_STREQ(InputError("city.boxmap", "too short").what(), "city.boxmap: too short");
}

}  // namespace
}  // namespace geom
