#include "geom/text/xml_head.h"

#include <gtest/gtest.h>

#include "support/refusal.h"

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
    EXPECT_NE(refusal(before + std::string("<!DOCTYPE a [<!ENTITY b SYSTEM 'c'>]><a>&b;</a>"))
                  .find("expected no document type"),
              std::string::npos);
  }
  EXPECT_NE(refusal("<!-- -->\n\n<!DOCTYPE a>").find("f:3:"), std::string::npos);
}

TEST(XmlHead, RefusesWhatItCannotLookInto) {
  using std::string_literals::operator""s;
  for (const std::string& head : {"\xff\xfe<\0"s, "\xfe\xff\0<"s, "<\0!\0"s, "\0<\0!"s}) {
    EXPECT_NE(refusal(head).find("UTF-16"), std::string::npos);
  }
  EXPECT_NE(refusal("<!-- " + std::string(kXmlHead, 'x')).find("first MiB"), std::string::npos);
}

}  // namespace
}  // namespace geom
