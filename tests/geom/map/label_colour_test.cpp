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

TEST(ColourOfLabel, IsThreeNumbersUpTo255OrShares) {
  EXPECT_EQ(colour_of_label("255 0 0"), (Rgb{255, 0, 0}));
  EXPECT_EQ(colour_of_label("0 128 7"), (Rgb{0, 128, 7}));
  EXPECT_EQ(colour_of_label("1 0 0"), (Rgb{255, 0, 0}));
  EXPECT_EQ(colour_of_label("0.5 1 0"), (Rgb{128, 255, 0}));
  EXPECT_EQ(colour_of_label("0 0 0"), (Rgb{0, 0, 0}));
  EXPECT_EQ(colour_of_label("1 0 2"), (Rgb{1, 0, 2}));
}

TEST(ColourOfLabel, IsNothingForAnythingElse) {
  for (const char* label : {"", "tower", "255", "255 0", "255 0 0 0", "256 0 0", "-1 0 0",
                            "nan 0 0", "255,0,0", "255  0 0", " 255 0 0", "255 0 0 "}) {
    EXPECT_FALSE(colour_of_label(label)) << label;
  }
}

TEST(LabelColour, IsWhatTheLabelSaysElseOfItsNumber) {
  EXPECT_EQ(label_colour(2, "255 0 0"), (Rgb{255, 0, 0}));
  EXPECT_EQ(label_colour(2, "house"), label_colour(2));
}

}  // namespace
}  // namespace geom
