#include "geom/import/building_height.h"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <string_view>

namespace geom {
namespace {

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

TEST(BuildingHeight, TakesTheHigherOfTwoHeights) {
  EXPECT_EQ(from({{"height", "20"}, {"building:height", "30"}}).top, 30);
  EXPECT_EQ(from({{"height", "20"}, {"building:height", "9"}}).top, 20);
}

TEST(IsAttribute, MatchesInAnyCase) {
  EXPECT_TRUE(is_attribute("HEIGHT", "height"));
  EXPECT_TRUE(is_attribute("Building:Height", "building:height"));
  EXPECT_FALSE(is_attribute("height_m", "height"));
  EXPECT_FALSE(is_attribute("", "height"));
}

TEST(AddValue, MakesAListWithoutBlanks) {
  std::string list;
  for (const char* value : {"", "3", " ", "50 m"}) add_value(value, list);
  EXPECT_EQ(list, "3;50 m");
}

TEST(BuildingHeight, CountsStoreysAndTheRoof) {
  EXPECT_EQ(from({{"building:levels", "3"}}).top, 9);
  EXPECT_EQ(from({{"building:levels", "3"}, {"roof:levels", "1"}}).top, 12);
  EXPECT_EQ(from({{"building:levels:aboveground", "30"}}).top, 90);
  EXPECT_EQ(from({{"building:levels", "3"}, {"building:levels:aboveground", "30"}}).top, 90);
  EXPECT_EQ(from({{"building:levels", "3"}, {"building:levels:aboveground", "2"}}).top, 9);
  EXPECT_EQ(from({{"building:levels", "3"}, {"roof:height", "2.5"}}).top, 11.5);
}

TEST(BuildingHeight, FallsBackAndSaysSo) {
  const BuildingHeight h = from({{"height", "very"}});
  EXPECT_EQ(h.top, 10);
  EXPECT_EQ(h.from, HeightFrom::nothing);
  EXPECT_TRUE(h.junk);
  EXPECT_TRUE(h.unread);
  EXPECT_FALSE(from({}).junk);
}

TEST(BuildingHeight, StartsWhereItHangs) {
  EXPECT_EQ(from({{"height", "20"}, {"min_height", "5"}}).bottom, 5);
  EXPECT_EQ(from({{"height", "20;30"}, {"min_height", "5;4"}}).top, 30);
  EXPECT_EQ(from({{"height", "20;30"}, {"min_height", "5;4"}}).bottom, 4);
}

// Storeys of 2.5 m: a guess of 3 m would leave a slot above the part that ends at 12.5 m.
TEST(BuildingHeight, StartsOnTheGroundWhereOnlyStoreysSayOtherwise) {
  const BuildingHeight h =
      from({{"height", "25"}, {"building:levels", "10"}, {"building:min_level", "5"}});
  EXPECT_EQ(h.bottom, 0);
  EXPECT_EQ(h.top, 25);
  EXPECT_FALSE(h.junk);
  EXPECT_EQ(from({{"building:levels", "10"}, {"building:min_level", "5"}}).bottom, 0);
  EXPECT_EQ(from({{"height", "25"}, {"min_height", "9"}, {"building:min_level", "5"}}).bottom, 9);
  EXPECT_EQ(from({{"height", "25"}, {"min_height", "?"}, {"building:min_level", "5"}}).bottom, 0);
}

TEST(BuildingHeight, IsAsHighAsBothTogetherWhereItsStoreysBeginAboveItsTop) {
  const BuildingHeight h = from({{"height", "10"}, {"building:min_level", "4"}});
  EXPECT_EQ(h.bottom, 0);
  EXPECT_EQ(h.top, 22);
  EXPECT_TRUE(h.junk);
}

// 20 m from 25 m up, as some mean it, or a slip: what it may be is in the map.
TEST(BuildingHeight, IsKeptWhereItWouldBeginAboveItsTop) {
  const BuildingHeight inverted = from({{"height", "20"}, {"min_height", "25"}});
  EXPECT_EQ(inverted.bottom, 0);
  EXPECT_EQ(inverted.top, 45);
  EXPECT_TRUE(inverted.junk);
  const BuildingHeight canopy = from({{"min_height", "12"}});
  EXPECT_EQ(canopy.top, 22);
  EXPECT_EQ(canopy.from, HeightFrom::nothing);
}

TEST(BuildingHeight, PassesOverHeightsOfNothing) {
  for (const char* none : {"0", "-1", "0 m", "-999"}) {
    const BuildingHeight levels = from({{"height", none}, {"building:levels", "12"}});
    EXPECT_EQ(levels.top, 36) << none;
    EXPECT_EQ(levels.from, HeightFrom::levels);
    EXPECT_FALSE(levels.unread);
    EXPECT_EQ(from({{"height", none}, {"building:height", "15"}}).top, 15);
    EXPECT_EQ(from({{"height", none}}).top, 10);
    EXPECT_EQ(from({{"height", none}}).from, HeightFrom::nothing);
  }
  EXPECT_EQ(from({{"building:levels", "-1"}}).from, HeightFrom::nothing);
  EXPECT_EQ(from({{"building:levels", "0"}, {"roof:levels", "2"}}).top, 6);
}

TEST(BuildingHeight, TakesAnEstimateAndTheHigherOfItAndTheStoreys) {
  EXPECT_EQ(from({{"est_height", "40"}}).top, 40);
  EXPECT_EQ(from({{"est_height", "40"}}).from, HeightFrom::height);
  EXPECT_EQ(from({{"est_height", "40"}, {"building:levels", "3"}}).top, 40);
  EXPECT_EQ(from({{"est_height", "5"}, {"building:levels", "3"}}).top, 9);
  EXPECT_EQ(from({{"est_height", "5"}, {"building:levels", "3"}}).from, HeightFrom::levels);
}

TEST(BuildingHeight, ReadsAHeightInStoreysAsNone) {
  const BuildingHeight h = from({{"height", "10-20 storeys"}});
  EXPECT_EQ(h.from, HeightFrom::nothing);
  EXPECT_TRUE(h.unread);
  EXPECT_EQ(from({{"building:levels", "12;18 floors"}}).top, 54);
}

TEST(BuildingHeight, KnowsWhatNoDefaultFits) {
  EXPECT_TRUE(from({{"man_made", "tower"}}).tower);
  EXPECT_TRUE(from({{"building", "Bell_Tower"}}).tower);
  EXPECT_TRUE(from({{"building", "yes"}, {"tower:type", "cooling"}}).tower);
  EXPECT_TRUE(from({{"man_made", "works;chimney"}}).tower);
  EXPECT_TRUE(from({{"fclass", "crane"}}).tower);
  EXPECT_FALSE(from({{"building", "yes"}}).tower);
}

TEST(BuildingHeight, SaysWhetherTheAttributeOfTheOptionsIsThere) {
  HeightOptions options;
  options.attribute = "h_max";
  const auto tag = [](const char* key) {
    return std::string(std::string_view(key) == "h_max" ? "31" : "");
  };
  EXPECT_TRUE(building_height(tag, options).asked);
  EXPECT_EQ(building_height(tag, options).top, 31);
  EXPECT_FALSE(building_height(tag, {}).asked);
}

}  // namespace
}  // namespace geom
