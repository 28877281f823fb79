#include "geom/text/xml_element.h"

#include <gtest/gtest.h>

#include "support/reading.h"

namespace geom {
namespace {

TEST(XmlElement, IsATreeWithLinesPrefixesAttributesAndText) {
  const XmlElement root = parse_xml(
      "\xef\xbb\xbf<?xml version=\"1.0\"?>\n<!-- c -->\n<a x='1' k:y=\"a &amp; b&#x41;\">\n <k:b/>"
      "t&lt;<![CDATA[<raw>]]></a>",
      "f.xml");
  EXPECT_EQ(root.name, "a");
  EXPECT_EQ(root.line, 3u);
  using Attributes = std::vector<std::pair<std::string, std::string>>;
  EXPECT_EQ(root.attributes, (Attributes{{"x", "1"}, {"k:y", "a & bA"}}));
  ASSERT_EQ(root.children.size(), 1u);
  EXPECT_EQ(root.children[0].prefix, "k");
  EXPECT_EQ(root.children[0].name, "b");
  EXPECT_EQ(root.children[0].line, 4u);
  EXPECT_EQ(root.text, "\n t<<raw>");
}

TEST(XmlElement, HasItsChildrenInTheirOrderAtEveryDepth) {
  std::string text;
  for (int i = 0; i < 9; ++i) text += "<b>" + std::to_string(i) + "<c/><d>e</d></b>";
  const XmlElement root = parse_xml("<a>" + text + "</a>", "f.xml");
  ASSERT_EQ(root.children.size(), 9u);
  for (std::size_t i = 0; i < 9; ++i) {
    EXPECT_EQ(root.children[i].text, std::to_string(i));
    ASSERT_EQ(root.children[i].children.size(), 2u);
    EXPECT_EQ(root.children[i].children[1].text, "e");
  }
}

TEST(XmlElement, IsRefusedByTheRulesOfTheReader) {
  EXPECT_EQ(support::refusal_of([] { parse_xml("<a>\n</b>", "f.xml"); }),
            "f.xml:2: expected the end of the element of line 1, found another's");
  EXPECT_TRUE(support::says(support::refusal_of([] {
                              parse_xml("<!DOCTYPE a [<!ENTITY b \"cc\">]><a>&b;</a>", "f.xml");
                            }),
                            "expected no document type"));
}

}  // namespace
}  // namespace geom
