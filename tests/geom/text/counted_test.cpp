#include "geom/text/counted.h"

#include <gtest/gtest.h>

namespace {

TEST(Counted, IsSingularForOneAlone) {
  EXPECT_EQ(geom::counted(1, "box", "boxes"), "1 box");
  EXPECT_EQ(geom::counted(0, "box", "boxes"), "0 boxes");
  EXPECT_EQ(geom::counted(2, "point"), "2 points");
}

}  // namespace
