#include "mission/dji/wpml_fields.h"

#include <gtest/gtest.h>

#include "support/reading.h"

namespace traj {
namespace {

XmlElement parsed(const std::string& inside) {
  return parse_xml("<wpml:a>\n" + inside + "</wpml:a>", "f");
}

std::string refusal(const std::string& inside, const WpmlChildren& children) {
  return support::refusal_of([&] {
    const XmlElement root = parsed(inside);
    WpmlFields(root, "f", children);
  });
}

TEST(WpmlFields, KnowEveryChild) {
  EXPECT_EQ(refusal("<wpml:b/><c/><c/>", {{"wpml:b"}, {"c"}}), "");
  EXPECT_EQ(refusal("<b/>", {{"wpml:b"}}),
            "f:2: <b> in <wpml:a> is not known here, and might move the aircraft");
  EXPECT_EQ(refusal("<x:b/>", {{"wpml:b"}}),
            "f:2: <x:b> in <wpml:a> is not known here, and might move the aircraft");
  EXPECT_EQ(refusal("<wpml:b/>\n<wpml:b/>", {{"wpml:b"}}),
            "f:3: expected one <wpml:b> in <wpml:a>, found two");
  EXPECT_EQ(refusal("<d/><wpml:b/>", {{"wpml:b"}, {}, true}), "");
  EXPECT_NE(refusal("<wpml:b/><wpml:b/>", {{"wpml:b"}, {}, true}), "");
}

TEST(WpmlFields, GiveTheirValues) {
  const XmlElement root =
      parsed("<wpml:n> 2.5 </wpml:n><wpml:i>7</wpml:i><wpml:w>on</wpml:w><m>1</m><m>2</m>");
  const WpmlFields fields(root, "f", {{"wpml:n", "wpml:i", "wpml:w"}, {"m"}});
  EXPECT_EQ(fields.number("wpml:n", 0, 3), 2.5);
  EXPECT_EQ(fields.whole("wpml:i"), 7);
  EXPECT_EQ(fields.word("wpml:w", {"on", "off"}), "on");
  EXPECT_EQ(fields.text("wpml:n"), "2.5");
  EXPECT_EQ(fields.all("m").size(), 2u);
  EXPECT_FALSE(fields.find("wpml:x"));
}

TEST(WpmlFields, RefuseOtherValues) {
  const XmlElement root =
      parsed("<wpml:n>2,5</wpml:n><wpml:i>7.5</wpml:i><wpml:w>on</wpml:w><wpml:o><b/></wpml:o>");
  const WpmlFields fields(root, "f", {{"wpml:n", "wpml:i", "wpml:w", "wpml:o"}});
  const auto says = [](const auto& f) { return support::refusal_of(f); };
  EXPECT_EQ(says([&] { fields.number("wpml:n", 0, 3); }),
            "f:2: <wpml:n> must be a number from 0 to 3, found \"2,5\"");
  EXPECT_EQ(says([&] { fields.number("wpml:i", 0, 3); }),
            "f:2: <wpml:i> must be a number from 0 to 3, found \"7.5\"");
  EXPECT_EQ(says([&] { fields.whole("wpml:i"); }),
            "f:2: <wpml:i> must be a whole number, found 7.5");
  EXPECT_EQ(says([&] {
              fields.word("wpml:w", {"off", "0"});
            }),
            "f:2: <wpml:w> must be off or 0, found \"on\"");
  EXPECT_EQ(says([&] { fields.text("wpml:o"); }),
            "f:2: expected a value in <wpml:o>, found an element");
  EXPECT_EQ(says([&] { fields.text("wpml:x"); }), "f:1: expected <wpml:x> in <wpml:a>, found none");
}

TEST(WpmlNumber, IsWholeAndFinite) {
  double value = 0;
  EXPECT_TRUE(read_wpml_number("-1.5e1", value));
  EXPECT_EQ(value, -15);
  for (const char* text : {"", " 1", "1 ", "nan", "inf", "1e999", "1,5", "+1", "0x1"}) {
    EXPECT_FALSE(read_wpml_number(text, value)) << text;
  }
}

}  // namespace
}  // namespace traj
