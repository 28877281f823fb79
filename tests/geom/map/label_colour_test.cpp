#include "geom/map/label_colour.h"

#include <gtest/gtest.h>

#include <set>

namespace geom {
namespace {

TEST(LabelColour, IsGreyFirstAndThenOneOfFiveOthers) {
  const auto grey = label_colour(0);
  EXPECT_EQ(grey[0], grey[1]);
  EXPECT_EQ(grey[1], grey[2]);
  std::set<std::array<std::uint8_t, 3>> seen;
  for (std::uint32_t label = 0; label < 6; ++label) seen.insert(label_colour(label));
  EXPECT_EQ(seen.size(), 6u);
  EXPECT_EQ(label_colour(6), grey);
  EXPECT_TRUE(seen.count(label_colour(0xffffffff)));
}

}  // namespace
}  // namespace geom
