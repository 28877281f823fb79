#include "text/xml_events.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "support/reading.h"

namespace geom {
namespace {

// What comes by, as one line.
class Written : public XmlHandler {
 public:
  void begin(const XmlTag& tag) override {
    all += '<' + std::string(tag.space) + '|' + std::string(tag.name);
    for (const auto& [name, value] : tag.attributes) {
      all += ' ' + std::string(name) + '=' + std::string(value);
    }
    all += '>';
    ids.emplace_back(tag.attribute("id"));
    lines.push_back(tag.line);
    unknown += tag.has_unknown_prefix();
  }
  void text(std::string_view part) override { all += part; }
  void end(std::size_t line) override { all += '/' + std::to_string(line); }

  std::string all;
  std::vector<std::string> ids;
  std::vector<std::size_t> lines;
  int unknown = 0;
};

Written written(const std::string& text) {
  Written out;
  read_xml(support::Text(text), "f.xml", out);
  return out;
}

std::string refusal(const std::string& text) {
  return support::refusal_of([&] { written(text); });
}

TEST(XmlEvents, ComeInTheOrderOfTheFile) {
  EXPECT_EQ(written("<a x='1'>\n<b>t&lt;<!-- c --><![CDATA[<r>]]></b>\n</a>").all,
            "<|a x=1>\n<|b>t<<r>/2\n/3");
  EXPECT_EQ(written("<a>\n\n<b/>\n<c/></a>").lines, (std::vector<std::size_t>{1, 3, 4}));
}

TEST(XmlEvents, HaveTheNamespaceThatHoldsWhereTheyStand) {
  EXPECT_EQ(written("<a xmlns='u' xmlns:p='v'><p:b xmlns='w'><c/></p:b><d/></a>").all,
            "<u|a xmlns=u xmlns:p=v><v|b xmlns=w><w|c>/1/1<u|d>/1/1");
}

TEST(XmlEvents, TellOfAPrefixThatIsNotDeclared) {
  EXPECT_EQ(written("<a><p:b xmlns:p='u'/><p:c/></a>").unknown, 1);
  EXPECT_EQ(written("<a xmlns=''><b/></a>").unknown, 0);
}

TEST(XmlEvents, FindAnAttributeWithAnyPrefixButNoDeclaration) {
  EXPECT_EQ(written("<a gml:id='1' xmlns:gml='u'><b id='2'/><c xmlns:id='3' gid='4'/></a>").ids,
            (std::vector<std::string>{"1", "2", ""}));
}

TEST(XmlEvents, AreTheSameWhereverTheFileIsCut) {
  std::string text = "<a>";
  for (int i = 0; i < 30000; ++i) text += "<b x='\xc3\xa4'>1 &amp; 2</b>\n";
  text += "</a>";
  Written whole;
  read_xml(std::string_view(text), "f.xml", whole);
  EXPECT_EQ(whole.all, written(text).all);
}

TEST(XmlEvents, HaveTheirTextsInUtf8FromEveryEncodingThatIsRead) {
  using std::string_literals::operator""s;
  const auto declared = [](const std::string& encoding, const std::string& text) {
    return written("<?xml version='1.0' encoding='" + encoding + "'?><a>" + text + "</a>").all;
  };
  EXPECT_EQ(declared("utf-8", "\xc3\xa4"), "<|a>\xc3\xa4/1");
  EXPECT_EQ(declared("ISO-8859-1", "\xe4\x80"), "<|a>\xc3\xa4\xc2\x80/1");
  EXPECT_EQ(declared("Windows-1252", "\xe4\x80"), "<|a>\xc3\xa4\xe2\x82\xac/1");
  EXPECT_EQ(declared("us-ascii", "a"), "<|a>a/1");
  EXPECT_EQ(written("\xff\xfe<\0a\0/\0>\0"s).all, "<|a>/1");
}

TEST(XmlEvents, RefuseOtherEncodingsAndBytesThatTheirsHasNot) {
  EXPECT_TRUE(refusal("<?xml version='1.0' encoding='koi8-r'?><a/>")
                  .starts_with("f.xml:1: expected UTF-8, UTF-16"));
  for (const char* text : {"<a>\xe4</a>", "<?xml version='1.0' encoding='us-ascii'?><a>\xe4</a>",
                           "<?xml version='1.0' encoding='windows-1252'?><a>\x81</a>",
                           "<?xml version='1.0' encoding='utf-16'?><a/>"}) {
    EXPECT_NE(refusal(text), "") << text;
  }
}

TEST(XmlEvents, RefuseWhatIsNotWellFormed) {
  for (const auto& [text, why] : std::vector<std::pair<std::string, std::string>>{
           {"", "f.xml:1: expected an element, found the end of the file"},
           {"<a>\n<b>\n", "f.xml:3: the element of line 2 is not ended: the file may be cut"},
           {"<a><b", "f.xml:1: a tag, a comment or a text is not ended"},
           {"<a>\n<!-- ", "f.xml:2: a tag, a comment or a text is not ended"},
           {"<a>\n</b>", "f.xml:2: expected the end of the element of line 1, found another's"},
           {"<a x='1' x='2'/>", "f.xml:1: expected each attribute of a tag once"},
           {"<a/>\n<b/>", "f.xml:2: expected nothing more after the root element, found \"<b/>\""},
           {"<a>&rest;</a>", "f.xml:1: expected only entities of XML itself, found \"&rest;"},
           {"<a>&#0;</a>", "f.xml:1: expected the number of a character after &#"},
           {"\n<?xml version='1.0'?><a/>", "f.xml:2: expected <?xml ...?> at the first byte"},
           {"<a x=1/>", "f.xml:1: expected well-formed XML, found \"1/>\""},
           {"<a>\x01</a>", "f.xml:1: expected well-formed XML, found \"\\x01</a>\""},
           {"<a x='<'/>", "f.xml:1: expected well-formed XML, found \"<'/>\""},
           {"<a>]]></a>", "f.xml:1: expected well-formed XML, found \"></a>\""},
           {"text", "f.xml:1: expected well-formed XML, found \"text\""}}) {
    EXPECT_TRUE(refusal(text).starts_with(why)) << text << "\n" << refusal(text);
  }
}

TEST(XmlEvents, RefuseADocumentTypeAndElementsOfXInclude) {
  EXPECT_TRUE(
      refusal("<?xml version='1.0'?>\n<!DOCTYPE a><a/>").starts_with("f.xml:2: expected no doc"));
  constexpr const char* kInclude = "http://www.w3.org/2001/XInclude";
  for (const std::string& text :
       {"<a>\n<i:include xmlns:i='" + std::string(kInclude) + "'/></a>",
        "<a xmlns:i='" + std::string(kInclude) + "'>\n<b><i:fallback/></b></a>",
        "<a>\n<include xmlns='" + std::string(kInclude) + "'/></a>"}) {
    EXPECT_TRUE(refusal(text).starts_with("f.xml:2: expected the whole file")) << text;
  }
  // What `xmllint --xinclude` leaves behind, as the refusal advises.
  EXPECT_EQ(refusal("<a xmlns:i='" + std::string(kInclude) + "'><b/></a>"), "");
}

TEST(XmlEvents, RefuseElementsNestedDeeperThanTwoHundred) {
  const auto nested = [](std::size_t depth) {
    std::string text;
    for (std::size_t i = 0; i < depth; ++i) text += "<a>";
    for (std::size_t i = 0; i < depth; ++i) text += "</a>";
    return text;
  };
  EXPECT_EQ(refusal(nested(200)), "");
  EXPECT_TRUE(support::says(refusal(nested(201)), "nested at most 200 deep"));
  EXPECT_TRUE(support::says(refusal(nested(1000000)), "nested at most 200 deep"));
}

TEST(XmlEvents, EndWithWhatTheHandlerThrows) {
  class Throws : public Written {
    void text(std::string_view) override { throw std::length_error("enough"); }
  };
  Throws handler;
  EXPECT_THROW(read_xml(std::string_view("<a>t<b/></a>"), "f.xml", handler), std::length_error);
  EXPECT_EQ(handler.all, "<|a>");
}

}  // namespace
}  // namespace geom
