#include "geom/map/label_colour.h"

#include <gtest/gtest.h>

#include <set>

namespace geom {
namespace {

TEST(LabelColour, IsGreyFirstAndThenOneOfFiveOthers) {
  const auto grey = label_colour(0);
  EXPECT_EQ(grey[0], grey[1]);
  EXPECT_EQ(grey[1], grey[2]);
  std::set<Rgb8> seen;
  for (std::uint32_t label = 0; label < 6; ++label) seen.insert(label_colour(label));
  EXPECT_EQ(seen.size(), 6u);
  EXPECT_EQ(label_colour(6), grey);
  EXPECT_TRUE(seen.count(label_colour(0xffffffff)));
}

TEST(LabelColour, IsTheOneThatABlockTextWrites) {
  EXPECT_EQ(written_colour("255 0 0"), (Rgb8{255, 0, 0}));
  EXPECT_EQ(written_colour("0 127.6 255"), (Rgb8{0, 128, 255}));
  EXPECT_EQ(written_colour("0 0 0"), (Rgb8{0, 0, 0}));
  EXPECT_EQ(label_colour(1, "0 255 0"), (Rgb8{0, 255, 0}));
}

TEST(LabelColour, IsAShareOfOneWhereNoPartIsLarger) {
  EXPECT_EQ(written_colour("1 0 0"), (Rgb8{255, 0, 0}));
  EXPECT_EQ(written_colour("0.5 0.2 1"), (Rgb8{128, 51, 255}));
}

TEST(LabelColour, IsNotWrittenByOtherWords) {
  for (const char* label : {"", "house", "255 0", "255 0 0 0", "256 0 0", "-1 0 0", "nan 0 0",
                            "255,0,0", "255 0 red"}) {
    EXPECT_FALSE(written_colour(label)) << label;
  }
  EXPECT_EQ(label_colour(2, "house"), label_colour(2));
}

TEST(KeepOut, IsNamedByItsLabel) {
  for (const char* label : {"keep-out", "keep-out: stadium", "fence"}) {
    EXPECT_TRUE(is_keep_out(label)) << label;
  }
  for (const char* label : {"", "keep-outs", "fences", "house", "Fence"}) {
    EXPECT_FALSE(is_keep_out(label)) << label;
  }
}

}  // namespace
}  // namespace geom
