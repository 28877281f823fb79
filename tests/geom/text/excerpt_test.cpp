#include "geom/text/excerpt.h"

#include <gtest/gtest.h>

namespace geom {
namespace {

TEST(Printable, LeavesWordsOfAnyLanguageAsTheyStand) {
  EXPECT_EQ(printable("Straße 7, 東京 🚁"), "Straße 7, 東京 🚁");
  EXPECT_EQ(printable(""), "");
}

TEST(Printable, EscapesWhatSteersATerminal) {
  EXPECT_EQ(printable("a\x1b[2Jb\x7f\n\t\r"), "a\\x1b[2Jb\\x7f\\n\\t\\r");
  EXPECT_EQ(printable(std::string_view("\0x", 2)), "\\x00x");
  EXPECT_EQ(printable("\xc2\x9b"
                      "2J"),
            "\\u009b2J");  // C1: begins a sequence too
}

TEST(Printable, EscapesWhatReordersOrHidesText) {
  EXPECT_EQ(printable("ok\xe2\x80\xae"
                      "ko"),
            "ok\\u202eko");
  EXPECT_EQ(printable("a\xe2\x80\x8b\xef\xbb\xbf"), "a\\u200b\\ufeff");
}

TEST(Printable, EscapesBytesThatAreNoUtf8) {
  EXPECT_EQ(printable("\xff\xfe"), "\\xff\\xfe");
  EXPECT_EQ(printable("Stra\xdf"
                      "e"),
            "Stra\\xdfe");                                  // Latin-1
  EXPECT_EQ(printable("\xc0\xaf"), "\\xc0\\xaf");           // longer than need be
  EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80");  // a surrogate
  EXPECT_EQ(printable("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");
  EXPECT_EQ(printable("\xe6\x9d"), "\\xe6\\x9d");  // cut off
}

TEST(Excerpt, EndsInDotsWhatIsLonger) {
  EXPECT_EQ(excerpt("1234567890", 10), "1234567890");
  EXPECT_EQ(excerpt("12345678901", 10), "1234567...");
  EXPECT_LE(excerpt(std::string(1 << 20, '\x1b')).size(), 60u);
}

TEST(Excerpt, CutsNoCharacterInTwo) {
  EXPECT_EQ(excerpt("ääääääää", 10), "äää...");
  EXPECT_EQ(excerpt("\x1b\x1b\x1b\x1b", 10), "\\x1b...");
}

}  // namespace
}  // namespace geom
