#include "geom/text/markup.h"

#include <gtest/gtest.h>

namespace geom {
namespace {

TEST(EscapedMarkup, LetsBracketsAndAmpersandsStandForThemselves) {
  EXPECT_EQ(escaped_markup("a < b && c > d"), "a &lt; b &amp;&amp; c &gt; d");
  EXPECT_EQ(escaped_markup("&lt;"), "&amp;lt;");
}

TEST(EscapedMarkup, MakesControlCharactersSpacesAndLeavesOtherBytes) {
  EXPECT_EQ(escaped_markup(std::string_view("a\0b\n\tc\x1f", 7)), "a b  c ");
  EXPECT_EQ(escaped_markup("Österö '1'"), "Österö '1'");
}

TEST(EscapedMarkup, StandsBetweenQuotes) {
  EXPECT_EQ(escaped_markup("the \"1\""), "the &quot;1&quot;");
}

TEST(EscapedMarkup, MakesWhatIsNoCharacterASpace) {
  EXPECT_EQ(escaped_markup("a\xef\xbf\xbe\xef\xbf\xbf."), "a  .");
  EXPECT_EQ(escaped_markup("\xef\xbf\xbd\xef\xbf"), "\xef\xbf\xbd\xef\xbf");
}

}  // namespace
}  // namespace geom
