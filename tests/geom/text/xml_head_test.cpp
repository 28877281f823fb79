#include "text/xml_head.h"

#include <gtest/gtest.h>

#include "support/reading.h"

namespace geom {
namespace {

std::string refusal(const std::string& head) {
  return support::refusal_of([&] { require_plain_xml(head, "f"); });
}

TEST(XmlHead, PassesWhatHasNoDocumentType) {
  for (const char* head : {"", "x,y,z", "{\"a\":\"<!DOCTYPE\"}", "<a><!DOCTYPE", "\xef\xbb\xbf<a/>",
                           "<?xml version='1.0'?>\n<!-- <!DOCTYPE a> -->\n<?b <!DOCTYPE?><a/>"}) {
    EXPECT_EQ(refusal(head), "") << head;
  }
}

TEST(XmlHead, RefusesADocumentType) {
  for (const char* before : {"", " \n", "\xef\xbb\xbf", "<?xml version='1.0'?>\n<!-- <a> -->"}) {
    EXPECT_TRUE(support::says(
        refusal(before + std::string("<!DOCTYPE a [<!ENTITY b SYSTEM 'c'>]><a>&b;</a>")),
        "expected no document type"));
  }
  EXPECT_TRUE(support::says(refusal("<!-- -->\n\n<!DOCTYPE a>"), "f:3:"));
}

TEST(XmlHead, RefusesWhatItCannotLookInto) {
  using std::string_literals::operator""s;
  for (const std::string& head : {"\xff\xfe<\0"s, "\xfe\xff\0<"s, "<\0!\0"s, "\0<\0!"s}) {
    EXPECT_TRUE(support::says(refusal(head), "UTF-16"));
  }
  EXPECT_TRUE(support::says(refusal("<!-- " + std::string(kXmlHead, 'x')), "first MiB"));
}

TEST(XmlWatch, FindsAnInclusionWhereverPartsAreCut) {
  const std::string text =
      "<osm>\n<a/>\n<i:include xmlns:i=\"http://www.w3.org/2001/XInclude\" href=\"b\"/></osm>";
  for (std::size_t cut = 1; cut < text.size(); ++cut) {
    const std::string found = support::refusal_of([&] {
      XmlWatch watch("f");
      watch.look(std::string_view(text).substr(0, cut));
      watch.look(std::string_view(text).substr(cut));
    });
    EXPECT_TRUE(found.starts_with("f:3: expected the whole file")) << cut << ' ' << found;
  }
}

TEST(XmlWatch, PassesPartsWithoutOneAndRefusesADocumentTypeInTheFirst) {
  XmlWatch watch("f");
  for (const char* part : {"<osm>", "http://www.w3.org/2001/", "", "<XInclude/>"}) watch.look(part);
  EXPECT_TRUE(
      support::says(support::refusal_of([] { XmlWatch("f").look("<!DOCTYPE a><a/>"); }), "f:1:"));
}

}  // namespace
}  // namespace geom
