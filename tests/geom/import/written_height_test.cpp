#include "import/written_height.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cctype>

#include "geom/base/random.h"

namespace geom {
namespace {

TEST(ParseHighest, UnderstandsWhatPeopleWrite) {
  EXPECT_EQ(parse_highest("12.13 m"), 12.13);
  EXPECT_EQ(parse_highest("12,5"), 12.5);
  EXPECT_EQ(parse_highest(" ~15m "), 15);
  EXPECT_EQ(parse_highest("15 Metres"), 15);
  EXPECT_EQ(parse_highest("-3"), -3);
  EXPECT_DOUBLE_EQ(*parse_highest("40 ft"), 12.192);
  EXPECT_DOUBLE_EQ(*parse_highest("7'4\""), 7 * 0.3048 + 4 * 0.0254);
  EXPECT_EQ(parse_highest("250 cm"), 2.5);
}

TEST(ParseHighest, AddsInchesToFeet) {
  const double most = 100 * 0.3048 + 11 * 0.0254;
  for (const char* text : {"100'-11\"", "100' 11\"", "100'11\"", "100' 11", "100 ft 11 in",
                           "100ft 11in", "100 feet 11 inches", "100′ 11″", "100 ft. 11 in."}) {
    ASSERT_TRUE(parse_highest(text)) << text;
    EXPECT_NEAR(*parse_highest(text), most, 1e-12) << text;
  }
}

TEST(ParseHighest, ReadsThousandsWhereABuildingMayBeAsHigh) {
  EXPECT_DOUBLE_EQ(*parse_highest("1,250 ft"), 1250 * 0.3048);
  EXPECT_DOUBLE_EQ(*parse_highest("1,250.5 ft"), 1250.5 * 0.3048);
  EXPECT_DOUBLE_EQ(*parse_highest("1,250", 0.3048), 1250 * 0.3048);
  EXPECT_EQ(parse_highest("12,125 m"), 12.125);
  EXPECT_EQ(parse_highest("1,250"), 1.25);
  EXPECT_EQ(parse_highest("0,250 ft"), 0.25 * 0.3048);
}

TEST(ParseHighest, GivesNothingForTheRest) {
  for (const char* text : {"",
                           "tall",
                           "m 12",
                           "12 storeys",
                           "1e9",
                           "nan",
                           "inf",
                           "--3",
                           "12.1.3x",
                           "12 mi",
                           "12 m, 30 m with antenna",
                           "12 m2",
                           "12+",
                           ">12",
                           "3+2",
                           "12 18",
                           "5 ft 6",
                           "5'13\"",
                           "1,25,000 ft",
                           "1.250,5",
                           "1 250 ft",
                           "12 m ±1",
                           "12''",
                           "20000"}) {
    EXPECT_FALSE(parse_highest(text)) << text;
  }
}

TEST(ParseHighestAndLowest, TakeTheSideThatLeavesNothingOut) {
  EXPECT_EQ(parse_highest("3;40"), 40);
  EXPECT_EQ(parse_highest("30-40 m"), 40);
  EXPECT_EQ(parse_highest("30–40 m"), 40);
  EXPECT_EQ(parse_highest("-3"), -3);
  EXPECT_EQ(parse_lowest("3;1"), 1);
  EXPECT_EQ(parse_lowest("-2;1"), -2);
  EXPECT_DOUBLE_EQ(*parse_highest("30'-40'"), 40 * 0.3048);
  EXPECT_EQ(parse_lowest_level("2;4"), 2);
  EXPECT_EQ(parse_lowest_level("-1"), -1);
  EXPECT_EQ(parse_lowest_level("1--2"), -2);
}

TEST(ParseHighestAndLowest, ARangeHasOneUnit) {
  EXPECT_DOUBLE_EQ(*parse_highest("30-40 ft"), 40 * 0.3048);
  EXPECT_DOUBLE_EQ(*parse_lowest("30-40 ft"), 30 * 0.3048);
  EXPECT_FALSE(parse_highest("3;40 ft"));
  EXPECT_FALSE(parse_lowest("40;30 m", 0.3048));
  EXPECT_DOUBLE_EQ(*parse_highest("3;40 ft", 0.3048), 40 * 0.3048);
}

// "100'-11" may be 100 ft 11 in, or a range.
TEST(ParseHighestAndLowest, GiveNothingOfFeetAndANumberThatMayBeInches) {
  for (const char* text : {"100'-11", "100'-11;3", "100 ft-11", "100' - 5.5", "100'–11"}) {
    EXPECT_FALSE(parse_highest(text)) << text;
    EXPECT_FALSE(parse_lowest(text)) << text;
  }
  EXPECT_DOUBLE_EQ(*parse_highest("100'-11\""), 100 * 0.3048 + 11 * 0.0254);
  EXPECT_DOUBLE_EQ(*parse_highest("10'-11'"), 11 * 0.3048);
  EXPECT_DOUBLE_EQ(*parse_highest("10'-11 m"), 11);
  EXPECT_EQ(parse_highest("30'-40"), 40);
}

TEST(ParseHighestAndLowest, GiveNothingWhereAPartIsNotUnderstood) {
  for (const char* text : {"tall", "tall; 40", "3;?", "", "10-20 storeys", "12;18 floors", "3;"}) {
    EXPECT_FALSE(parse_highest(text)) << text;
    EXPECT_FALSE(parse_lowest(text)) << text;
  }
  EXPECT_FALSE(parse_lowest_level("2;ground"));
}

TEST(ParseLevels, TakesTheLargestNumber) {
  EXPECT_EQ(parse_levels("3"), 3);
  EXPECT_EQ(parse_levels("L3.5"), 3.5);
  EXPECT_EQ(parse_levels("2;4"), 4);
  EXPECT_EQ(parse_levels("3-5"), 5);
  EXPECT_EQ(parse_levels("10-20 storeys"), 20);
  EXPECT_EQ(parse_levels("12;18 floors"), 18);
}

TEST(ParseLevels, AddsWhatIsASum) {
  EXPECT_EQ(parse_levels("3+2"), 5);
  EXPECT_EQ(parse_levels("3 + 1 + 1"), 5);
  EXPECT_EQ(parse_levels("G+12"), 13);
  EXPECT_FALSE(parse_lowest_level("3+2"));
}

TEST(ParseLevels, GivesNothingForTheRest) {
  for (const char* text :
       {"ground", "1000", "3,5", "12/18", "10 to 20", "3 1/2", "G", "2B+", "many", "-3+2"}) {
    EXPECT_FALSE(parse_levels(text)) << text;
  }
}

// Whatever stands beside a number, it is understood or refused, and never read as less.
TEST(ParseHighest, NeverReadsLessThanWasWritten) {
  SplitMix64 random(34);
  const char* const beside[] = {"",      " ",  " m", "m",  " metres", " to ",    ";", "-", "+",
                                " and ", ", ", "/",  " (", ")",       " approx", "~", ">", " max "};
  constexpr int kBeside = static_cast<int>(std::size(beside));
  for (int i = 0; i < 10000; ++i) {
    double most = 0;
    std::string text;
    const int parts = random.whole(1, 3);
    for (int k = 0; k < parts; ++k) {
      const double metres = 3 + random.whole(0, 299) / 4.0;
      most = std::max(most, metres);
      text += fmt::format("{}{}", metres, beside[random.whole(0, kBeside - 1)]);
      if (k + 1 < parts && std::isdigit(static_cast<unsigned char>(text.back()))) text += ' ';
    }
    const auto read = parse_highest(text);
    if (!read) continue;
    EXPECT_GE(*read, most) << "\"" << text << "\"";
  }
}

}  // namespace
}  // namespace geom
