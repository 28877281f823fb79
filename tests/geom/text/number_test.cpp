#include "geom/text/number.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <string_view>

#include "geom/text/text_table.h"

namespace {

TEST(ParseNumber, WhatIsTooSmallIsAZeroWithItsSign) {
  for (const char* text : {"1e-400", "0.001e-330", "1e-99999999999999999999", "123456e-340"}) {
    const auto value = geom::parse_number(text);
    ASSERT_TRUE(value) << text;
    EXPECT_EQ(*value, 0) << text;
    EXPECT_FALSE(std::signbit(*value)) << text;
  }
  const auto negative = geom::parse_number("-1e-400");
  ASSERT_TRUE(negative);
  EXPECT_TRUE(*negative == 0 && std::signbit(*negative));
}

TEST(ParseNumber, WhatIsTooLargeIsNoNumber) {
  for (const char* text : {"1e400", "-1e400", "1e99999999999999999999", "0.0001e400"}) {
    EXPECT_FALSE(geom::parse_number(text)) << text;
  }
  EXPECT_FALSE(geom::parse_number(std::string(400, '9')));
}

TEST(ParseNumber, ManyZerosAreWeighedAgainstTheExponent) {
  EXPECT_EQ(geom::parse_number("0." + std::string(400, '0') + "1e401"), 1.0);
  EXPECT_EQ(geom::parse_number("1" + std::string(400, '0') + "e-400"), 1.0);
  EXPECT_EQ(geom::parse_number("0." + std::string(400, '0') + "1"), 0.0);
}

TEST(ParseNumber, KeepsDenormalsAndTheLargest) {
  EXPECT_EQ(geom::parse_number("5e-324"), std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(geom::parse_number("1.7976931348623157e308"), std::numeric_limits<double>::max());
  EXPECT_TRUE(std::isinf(geom::parse_number("-inf").value()));
}

// Digits, points, signs and exponents in any order, mostly numbers; and what follows them.
TEST(ReadNumber, GivesWhatFromCharsGives) {
  std::mt19937_64 random(4);
  const std::string_view kinds[] = {"0123456789", "0123456789.", "0123456789.-",
                                    "0123456789.e+-x,"};
  for (int i = 0; i < 400000; ++i) {
    const std::string_view letters = kinds[random() % 4];
    std::string text(random() % 3 ? "" : "-");
    for (std::size_t n = random() % 22; n > 0; --n) text += letters[random() % letters.size()];
    double expected = 1;
    double value = 1;
    const char* const end = text.data() + text.size();
    const auto standard = std::from_chars(text.data(), end, expected);
    if (standard.ec == std::errc::result_out_of_range) continue;
    const auto read = geom::read_number(text.data(), end, value);
    ASSERT_EQ(read.ec, standard.ec) << text;
    ASSERT_EQ(read.ptr, standard.ptr) << text;
    ASSERT_EQ(std::bit_cast<std::uint64_t>(value), std::bit_cast<std::uint64_t>(expected)) << text;
  }
}

TEST(ReadNumber, LeavesWhatFollows) {
  const std::string text = "-1e-400,7";
  double value = 1;
  const auto [rest, error] = geom::read_number(text.data(), text.data() + text.size(), value);
  EXPECT_EQ(error, std::errc());
  EXPECT_EQ(*rest, ',');
  EXPECT_EQ(value, 0);
}

TEST(AppendNumber, WritesTheShortestTextThatReadsBack) {
  std::string text;
  for (const double value : {0.1, -0.0, 100000.0, 5e-324, 1.7976931348623157e308}) {
    geom::append_number(text, value);
    text += ' ';
  }
  EXPECT_EQ(text, "0.1 -0 1e+05 5e-324 1.7976931348623157e+308 ");
}

TEST(AppendNumber, WritesWhatIsNotFiniteAsNull) {
  std::string text;
  for (const double value :
       {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
        std::numeric_limits<double>::quiet_NaN()}) {
    geom::append_number(text, value);
  }
  EXPECT_EQ(text, "nullnullnull");
}

}  // namespace
