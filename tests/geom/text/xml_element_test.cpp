#include "geom/text/xml_element.h"

#include <gtest/gtest.h>

#include "support/refusal.h"

namespace geom {
namespace {

std::string refusal(const std::string& text) {
  return support::refusal_of([&] { parse_xml(text, "f.xml"); });
}

TEST(XmlElement, IsATreeWithLinesPrefixesAttributesAndText) {
  const XmlElement root = parse_xml(
      "\xef\xbb\xbf<?xml version=\"1.0\"?>\n<!-- c -->\n<a x='1' y=\"a &amp; b&#x41;\">\n <k:b/>"
      "t&lt;<![CDATA[<raw>]]></a>",
      "f.xml");
  EXPECT_EQ(root.name, "a");
  EXPECT_EQ(root.line, 3u);
  ASSERT_EQ(root.attributes.size(), 2u);
  EXPECT_EQ(root.attributes[0].second, "1");
  EXPECT_EQ(root.attributes[1].second, "a & bA");
  ASSERT_EQ(root.children.size(), 1u);
  EXPECT_EQ(root.children[0].prefix, "k");
  EXPECT_EQ(root.children[0].line, 4u);
  EXPECT_EQ(root.text, "\n t<<raw>");
}

TEST(XmlElement, RefusesWhatIsNotWellFormed) {
  EXPECT_EQ(refusal("<a><b></b></a>"), "");
  for (const char* bad : {"", "<a>", "<a></b>", "<a/><b/>", "<a>&unknown;</a>", "<a x='&lt'/>",
                          "<a x=1/>", "<a x='<'/>", "text", "<a>\x01</a>", "<a x='&#0;'/>"}) {
    EXPECT_NE(refusal(bad), "") << bad;
  }
}

TEST(XmlElement, HasNoEntitiesOfAFilesOwn) {
  EXPECT_NE(refusal("<!DOCTYPE a [<!ENTITY b \"cccc\"><!ENTITY d \"&b;&b;\">]><a>&d;</a>")
                .find("expected no document type"),
            std::string::npos);
}

TEST(XmlElement, IsNestedAtMostAHundredDeep) {
  const auto nested = [](std::size_t depth) {
    std::string text;
    for (std::size_t i = 0; i < depth; ++i) text += "<a>";
    for (std::size_t i = 0; i < depth; ++i) text += "</a>";
    return text;
  };
  EXPECT_EQ(refusal(nested(100)), "");
  EXPECT_NE(refusal(nested(101)).find("nested at most 100 deep"), std::string::npos);
  EXPECT_NE(refusal(nested(1000000)).find("nested at most 100 deep"), std::string::npos);
}

}  // namespace
}  // namespace geom
