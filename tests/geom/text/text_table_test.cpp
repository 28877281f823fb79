#include "geom/text/text_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <system_error>

#include "support/reading.h"

namespace geom {
namespace {

using Fields = std::vector<std::string>;

TEST(TextLines, AreNumberedFromOneAndTrimmed) {
  std::istringstream in("\xef\xbb\xbf a\r\n\n\tb, c \r\nlast");
  TextLines lines(in, "t.csv");
  Fields found;
  while (lines.next()) found.push_back(std::to_string(lines.number()) + std::string(lines.line()));
  EXPECT_EQ(found, (Fields{"1a", "2", "3b, c", "4last"}));
}

TEST(TextLines, OfATextInMemoryAreThoseOfAStream) {
  for (const char* text : {"", "a", "a\n", "\n\n", " a \r\n\n\tb, c \r\nlast", "#1\nb"}) {
    std::istringstream in(text);
    TextLines expected(in, "t.csv", true);
    TextLines lines(text, 5, "t.csv");
    while (expected.next()) {
      ASSERT_TRUE(lines.next()) << text;
      EXPECT_EQ(lines.line(), expected.line());
      EXPECT_EQ(lines.number(), 5 + expected.number());
    }
    EXPECT_FALSE(lines.next()) << text;
  }
  TextLines lines("b\nc\rd\n", 5, "t.csv");
  lines.next();
  EXPECT_EQ(support::refusal_of([&] { lines.next(); }), "t.csv:7: " + sentence(lone_return()));
}

TEST(TextLines, PassOverCommentsBeforeTheFirstLine) {
  std::istringstream in("# made by hand\n\n # twice\na\n#1\n");
  TextLines lines(in, "t.csv");
  Fields found;
  while (lines.next()) found.push_back(std::to_string(lines.number()) + std::string(lines.line()));
  EXPECT_EQ(found, (Fields{"2", "4a", "5#1"}));
}

TEST(TextLines, ShowCommentsToWhoAsksForThem) {
  std::istringstream in("# x y z\n1 2 3\n");
  TextLines lines(in, "t.xyz", true);
  ASSERT_TRUE(lines.next());
  EXPECT_EQ(lines.line(), "# x y z");
}

TEST(TextLines, RefuseACarriageReturnAloneInAComment) {
  std::istringstream in("# made by hand\rblock 0 0 0 1 1 1\n");
  TextLines lines(in, "t.txt");
  EXPECT_EQ(support::refusal_of([&] { lines.next(); }), "t.txt:1: " + sentence(lone_return()));
}

TEST(TextLines, RefuseWithSourceAndLine) {
  std::istringstream in("a\nb\n");
  TextLines lines(in, "t.csv");
  lines.next();
  lines.next();
  EXPECT_EQ(support::refusal_of([&] { lines.refuse({.says = "no good"}); }), "t.csv:2: no good");
}

TEST(TextLines, ThrowWhereReadingFailsRatherThanEnd) {
  std::istringstream in("a\n");
  in.setstate(std::ios::badbit);
  TextLines lines(in, "t.csv");
  EXPECT_THROW(lines.next(), std::system_error);
}

TEST(Trimmed, LosesBlanksAtBothEndsAlone) {
  EXPECT_EQ(trimmed(" \ta b\r "), "a b");
  EXPECT_EQ(trimmed(" \t\r"), "");
}

TEST(SplitFields, AreBetweenCommasOrBetweenSemicolonsWhereThereIsOne) {
  EXPECT_EQ(split_fields("a, b ,,c"), (Fields{"a", "b", "", "c"}));
  EXPECT_EQ(split_fields("1,5;2,5"), (Fields{"1,5", "2,5"}));
  EXPECT_EQ(split_fields(""), (Fields{""}));
  EXPECT_EQ(split_fields("a,"), (Fields{"a", ""}));
}

TEST(SplitFields, MayBeQuoted) {
  EXPECT_EQ(split_fields("\"a,b\",\"say \"\"so\"\"\",c;d", true),
            (Fields{"a,b", "say \"so\"", "c;d"}));
  EXPECT_EQ(split_fields("\"a,b\"", false), (Fields{"\"a", "b\""}));
}

TEST(ParseNumber, IsTheWholeFieldOrNothing) {
  EXPECT_EQ(parse_number("+1.5e3"), 1500);
  EXPECT_EQ(parse_number("-.5"), -0.5);
  EXPECT_TRUE(std::isnan(*parse_number("nan")));
  EXPECT_EQ(parse_number("-inf"), -HUGE_VAL);
  for (const char* none : {"", "+", "1x", "1 2", "x", " 1", "1,5", "0x10"}) {
    EXPECT_FALSE(parse_number(none)) << none;
  }
}

TEST(Coordinate, IsFiniteAndWithinAHundredThousandKilometres) {
  std::istringstream in("row\n");
  TextLines lines(in, "t.csv");
  lines.next();
  EXPECT_EQ(coordinate(lines, "x", "-1e8"), -1e8);
  for (const char* bad : {"1.0000001e8", "nan", "inf", "", "west"}) {
    const std::string said = support::refusal_of([&] { coordinate(lines, "height of x", bad); });
    EXPECT_TRUE(said.starts_with("t.csv:1: height of x")) << bad << ": " << said;
  }
}

}  // namespace
}  // namespace geom
