#include "geom/record/place.h"

#include <gtest/gtest.h>

namespace geom {
namespace {

Place metres(double x, double y, double z) { return Vec3(x, y, z); }

TEST(Place, IsMetresOrDegreesWithLetters) {
  EXPECT_EQ(parse_place("12.5,30,-5"), metres(12.5, 30, -5));
  EXPECT_EQ(parse_place("60.1719N,24.9414E,30"), Place(EarthPlace{60.1719, 24.9414, 30, false}));
  EXPECT_EQ(parse_place("24.9414E,60.1719N,30"), Place(EarthPlace{60.1719, 24.9414, 30, false}));
  EXPECT_EQ(parse_place("33.5S,70W,2above"), Place(EarthPlace{-33.5, -70, 2, true}));
  EXPECT_EQ(parse_place("90N,180E,0"), Place(EarthPlace{90, 180, 0, false}));
}

TEST(Place, IsNothingElse) {
  for (const char* text : {"",           "1,2",         "1,2,3,4",       "60N,24E",
                           "60N,24E,",   "60N,24N,3",   "60E,24E,3",     "60,24E,3",
                           "60N,24,3",   "-60N,24E,3",  "90.001N,24E,3", "60N,180.5E,3",
                           "nanN,24E,3", "N,E,3",       "60N,24E,above", "60N,24E,3 above",
                           "60n,24e,3",  "60 N,24E,3",  "1,2,3above",    "1,2,inf",
                           "1e9,2,3",    "60N,24E,1e9", "60N,24E,3,"}) {
    EXPECT_FALSE(parse_place(text)) << text;
  }
}

TEST(Height, IsOfTheMapOrAboveWhatStandsThere) {
  EXPECT_EQ(parse_height("-3")->metres, -3);
  EXPECT_FALSE(parse_height("-3")->above);
  EXPECT_TRUE(parse_height("2.5above")->above);
  EXPECT_EQ(parse_height("2.5above")->metres, 2.5);
  EXPECT_FALSE(parse_height(""));
  EXPECT_FALSE(parse_height("2.5m"));
}

}  // namespace
}  // namespace geom
