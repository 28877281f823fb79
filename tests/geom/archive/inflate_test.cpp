#include "archive/inflate.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace geom {
namespace {

using std::string_view_literals::operator""sv;

constexpr auto kThousandLetters = "\x4b\x4c\x1c\x05\xa3\x60\x14\x0c\x77\x00\x00"sv;  // "a", by zlib

std::optional<std::string> inflated_text(std::string_view data, std::size_t size) {
  return inflated(std::as_bytes(std::span(data)), size);
}

TEST(Inflated, GivesWhatTheDataHold) {
  EXPECT_EQ(inflated_text(kThousandLetters, 1000), std::string(1000, 'a'));
  EXPECT_EQ(inflated_text("\x01\x03\x00\xfc\xff"
                          "abc"sv,
                          3),
            "abc")
      << "stored in a block";
  EXPECT_EQ(inflated_text("\x03\x00"sv, 0), "");
}

TEST(Inflated, GivesNothingForAnotherSize) {
  EXPECT_FALSE(inflated_text(kThousandLetters, 999));
  EXPECT_FALSE(inflated_text(kThousandLetters, 1001));
  EXPECT_FALSE(inflated_text(kThousandLetters, 0));
  EXPECT_FALSE(inflated_text(kThousandLetters, std::size_t{1} << 40)) << "more than data can hold";
}

TEST(Inflated, GivesNothingForDataThatAreDamagedCutOrGoOn) {
  const std::string whole(kThousandLetters);
  EXPECT_FALSE(inflated_text(whole.substr(0, whole.size() - 1), 1000));
  EXPECT_FALSE(inflated_text(whole + '\0', 1000));
  EXPECT_FALSE(inflated_text("\x07"sv, 1)) << "a block of a kind that is none";
  EXPECT_FALSE(inflated_text("", 0));
}

}  // namespace
}  // namespace geom
