#include "geom/import/building_height.h"

#include <gtest/gtest.h>

#include <map>

namespace geom {
namespace {

TEST(ParseLength, UnderstandsWhatPeopleWrite) {
  EXPECT_EQ(parse_length("12.13 m"), 12.13);
  EXPECT_EQ(parse_length("12,5"), 12.5);
  EXPECT_EQ(parse_length(" ~15m "), 15);
  EXPECT_DOUBLE_EQ(*parse_length("40 ft"), 12.192);
  EXPECT_DOUBLE_EQ(*parse_length("7'4\""), 7 * 0.3048 + 4 * 0.0254);
  EXPECT_EQ(parse_length("250 cm"), 2.5);
  EXPECT_EQ(parse_length("3;4"), 3);
}

TEST(ParseLength, GivesNothingForTheRest) {
  for (const char* text :
       {"", "tall", "m 12", "12 storeys", "1e9", "nan", "inf", "--3", "12.1.3x", "12 mi"}) {
    EXPECT_FALSE(parse_length(text)) << text;
  }
}

TEST(ParseHighestAndLowest, TakeTheSideThatLeavesNothingOut) {
  EXPECT_EQ(parse_highest("3;40"), 40);
  EXPECT_EQ(parse_highest("30-40 m"), 40);
  EXPECT_EQ(parse_highest("tall; 40"), 40);
  EXPECT_EQ(parse_highest("-3"), -3);
  EXPECT_FALSE(parse_highest("tall"));
  EXPECT_EQ(parse_lowest("3;1"), 1);
  EXPECT_EQ(parse_lowest("-2;1"), -2);
  EXPECT_FALSE(parse_lowest("3;?"));
  EXPECT_FALSE(parse_lowest(""));
  EXPECT_EQ(parse_lowest_level("2;4"), 2);
  EXPECT_EQ(parse_lowest_level("-1"), -1);
  EXPECT_EQ(parse_lowest_level("1--2"), -2);
  EXPECT_FALSE(parse_lowest_level("2;ground"));
}

TEST(ParseLevels, TakesTheLargestNumber) {
  EXPECT_EQ(parse_levels("3"), 3);
  EXPECT_EQ(parse_levels("L3.5"), 3.5);
  EXPECT_EQ(parse_levels("2;4"), 4);
  EXPECT_EQ(parse_levels("3-5"), 5);
  EXPECT_FALSE(parse_levels("ground"));
  EXPECT_FALSE(parse_levels("1000"));
}

BuildingHeight from(std::map<std::string, std::string> tags) {
  return building_height(
      [&](const char* key) {
        const auto at = tags.find(key);
        return at == tags.end() ? std::string() : at->second;
      },
      {});
}

TEST(BuildingHeight, PrefersHeightOverStoreys) {
  const BuildingHeight h = from({{"height", "20"}, {"building:levels", "3"}});
  EXPECT_EQ(h.top, 20);
  EXPECT_EQ(h.from, HeightFrom::height);
}

TEST(BuildingHeight, CountsStoreysAndTheRoof) {
  EXPECT_EQ(from({{"building:levels", "3"}}).top, 9);
  EXPECT_EQ(from({{"building:levels", "3"}, {"roof:levels", "1"}}).top, 12);
  EXPECT_EQ(from({{"building:levels", "3"}, {"roof:height", "2.5"}}).top, 11.5);
}

TEST(BuildingHeight, FallsBackAndSaysSo) {
  const BuildingHeight h = from({{"height", "very"}});
  EXPECT_EQ(h.top, 10);
  EXPECT_EQ(h.from, HeightFrom::nothing);
  EXPECT_TRUE(h.junk);
  EXPECT_EQ(from({{"height", "-3"}}).top, 10);
  EXPECT_FALSE(from({}).junk);
}

TEST(BuildingHeight, StartsWhereItHangs) {
  EXPECT_EQ(from({{"height", "20"}, {"min_height", "5"}}).bottom, 5);
  EXPECT_EQ(from({{"height", "20"}, {"building:min_level", "2"}}).bottom, 6);
  EXPECT_EQ(from({{"height", "20"}, {"building:min_level", "-1"}}).bottom, 0);
  EXPECT_EQ(from({{"height", "20"}, {"building:min_level", "1;2"}}).bottom, 3);
  EXPECT_EQ(from({{"height", "20;30"}, {"min_height", "5;4"}}).top, 30);
  EXPECT_EQ(from({{"height", "20;30"}, {"min_height", "5;4"}}).bottom, 4);
  const BuildingHeight inverted = from({{"height", "20"}, {"min_height", "25"}});
  EXPECT_EQ(inverted.bottom, 0);
  EXPECT_TRUE(inverted.junk);
}

}  // namespace
}  // namespace geom
