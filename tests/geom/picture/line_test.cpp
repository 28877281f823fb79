#include "geom/picture/line.h"

#include <gtest/gtest.h>

namespace geom::picture {
namespace {

TEST(WayLine, HasTheColoursOfFiguresInTurn) {
  EXPECT_EQ(way_line(0, "a", {}).colour, (Colour{0, 0x72, 0xb2}));
  EXPECT_EQ(way_line(1, "b", {}).colour, (Colour{0xd5, 0x5e, 0}));
  EXPECT_EQ(way_line(8, "c", {}).colour, way_line(0, "a", {}).colour);
}

TEST(TreeLine, IsThinAndHasNoEndsToMark) {
  const Line line = tree_line(1, {0, 0, 0}, {1, 0, 0});
  EXPECT_FALSE(line.way);
  EXPECT_LT(line.width, way_line(0, "a", {}).width);
  EXPECT_NE(line.colour, tree_line(0, {0, 0, 0}, {1, 0, 0}).colour);
}

}  // namespace
}  // namespace geom::picture
