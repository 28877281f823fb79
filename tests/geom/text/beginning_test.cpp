#include "geom/text/beginning.h"

#include <gtest/gtest.h>

#include <string>

namespace geom {
namespace {

using std::string_literals::operator""s;

std::string zip(const std::string& name, const std::string& content) {
  std::string head = "PK\x03\x04" + std::string(22, '\0');
  head += static_cast<char>(name.size());
  head += std::string(3, '\0');
  return head + name + content;
}

TEST(Beginning, OfBytesMayStandBehindOthersAndHoldZeros) {
  EXPECT_TRUE((begins_with<"II*\0">("II*\0\x08"s)));
  EXPECT_FALSE((begins_with<"II*\0">("II*"s)));
  EXPECT_TRUE((begins_with<"ustar", 3>("abcustar")));
  EXPECT_FALSE((begins_with<"ustar", 3>("ab")));
}

TEST(Beginning, OfTextsIsBehindAMarkAndBlanks) {
  EXPECT_EQ(text_of("\xef\xbb\xbf \r\n\tvoxel 1"), "voxel 1");
  EXPECT_EQ(text_of(" \n"), "");
  EXPECT_TRUE((text_begins_with<"voxel ">("\xef\xbb\xbfvoxel 1")));
}

TEST(Beginning, FirstLineIsNeitherBlankNorAComment) {
  EXPECT_EQ(first_line("# a\n\n \t# b\n  block 1\nblock 2\n"), "block 1");
  EXPECT_EQ(first_line("block 1"), "block 1");
  EXPECT_EQ(first_line("# a\n\n"), "");
  EXPECT_EQ(first_line(""), "");
}

TEST(Beginning, OfXmlAndJsonHoldsAPart) {
  EXPECT_TRUE(is_xml_with("\n<?xml?><kml>", "<kml"));
  EXPECT_FALSE(is_xml_with("a <kml>", "<kml"));
  EXPECT_TRUE(is_json_with("[ { \"from\" : [ 1", "\"from\":["));
  EXPECT_FALSE(is_json_with("\"from\":[", "\"from\":["));
}

TEST(Beginning, OfJsonHasTheTypeThatStandsFirst) {
  EXPECT_TRUE(is_json_of_type(R"({ "type" : "path", "next": {"type": "tree"}})", "path"));
  EXPECT_FALSE(is_json_of_type(R"({ "type" : "path", "next": {"type": "tree"}})", "tree"));
  EXPECT_FALSE(is_json_of_type(R"({"type":"paths"})", "path"));
  EXPECT_FALSE(is_json_of_type(R"({"id":"path"})", "path"));
  EXPECT_FALSE(is_json_of_type(R"([{"type":"path"}])", "path"));
}

TEST(Beginning, OfAZipNamesItsFirstEntry) {
  EXPECT_EQ(first_zip_entry(zip("doc.kml", "<kml>")), "doc.kml");
  EXPECT_EQ(first_zip_entry("doc.kml"), "");
  EXPECT_TRUE((zip_with<".kml">(zip("doc.kml", ""))));
  EXPECT_FALSE((zip_with<".kml">(zip("a.txt", "doc.kml"))));
}

TEST(Beginning, OfAnArchiveSaysItsFormat) {
  EXPECT_TRUE(is_archive_of(zip("meta.json", R"({"version": 1, "format": "a-map")"), "a-map"));
  EXPECT_FALSE(is_archive_of(zip("meta.json", R"({"format":"a-mapping")"), "a-map"));
  EXPECT_FALSE(is_archive_of(zip("other.json", R"({"format":"a-map")"), "a-map"));
}

TEST(Beginning, IsNoLongerThanWhatIsThere) {
  const std::string whole = zip("meta.json", R"({"format":"a-map")");
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_FALSE(is_archive_of(whole.substr(0, size), "a-map")) << size;
    first_zip_entry(whole.substr(0, size));
  }
  EXPECT_TRUE(is_archive_of(whole, "a-map"));
}

TEST(Beginning, MeetsAnyOfSeveralConditions) {
  EXPECT_TRUE((any_of<begins_with<"a">, begins_with<"b">>("b")));
  EXPECT_FALSE((any_of<begins_with<"a">, begins_with<"b">>("c")));
}

}  // namespace
}  // namespace geom
