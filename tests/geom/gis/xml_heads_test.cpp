#include "gis/xml_heads.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <fstream>

#include "support/reading.h"
#include "support/temporary_folder.h"

namespace geom::gis {
namespace {

constexpr const char* kHidden =
    "<?xml version='1.0'?>\n<!DOCTYPE osm SYSTEM 'rest.dtd'>\n<osm>&rest;</osm>";
constexpr const char* kIncludes =
    "<osm>\n<i:include xmlns:i='http://www.w3.org/2001/XInclude' href='rest.osm'/></osm>";
constexpr const char* kPlain = "<?xml version='1.0'?>\n<osm><!-- <!DOCTYPE --></osm>";

class XmlHeads : public testing::Test {
 protected:
  std::string plain(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }
  std::string packed(const std::string& name, const std::string& text) const {
    const std::string path = folder_ / name;
    const gzFile file = gzopen(path.c_str(), "wb");
    gzwrite(file, text.data(), static_cast<unsigned>(text.size()));
    gzclose(file);
    return path;
  }

  support::TemporaryFolder folder_;
};

TEST_F(XmlHeads, OfOpenStreetMapAreLookedIntoAlsoWherePacked) {
  const auto refusal = [](const std::string& path) {
    return support::refusal_of([&] { require_plain_osm(path, "f"); });
  };
  EXPECT_TRUE(support::says(refusal(plain("a.osm", kHidden)), "f:2: expected no document type"));
  EXPECT_TRUE(
      support::says(refusal(packed("b.osm.gz", kHidden)), "f:2: expected no document type"));
  for (const std::string& path : {plain("e.osm", kIncludes), packed("f.osm.gz", kIncludes)}) {
    EXPECT_TRUE(support::says(refusal(path), "f:2: expected the whole file")) << path;
  }
  EXPECT_EQ(refusal(plain("c.osm", kPlain)), "");
  EXPECT_EQ(refusal(packed("d.osm.gz", kPlain)), "");
}

TEST_F(XmlHeads, OfFilesForGdalAreLookedIntoAlsoWherePacked) {
  const auto refusal = [](const std::string& path) {
    return support::refusal_of([&] { require_plain_vector(path, "f"); });
  };
  EXPECT_TRUE(support::says(refusal(plain("a.kml", kHidden)), "expected no document type"));
  EXPECT_TRUE(support::says(refusal(packed("b.gml.gz", kHidden)), "expected no document type"));
  for (const std::string& path : {plain("e.kml", kIncludes), packed("f.gml.gz", kIncludes)}) {
    EXPECT_TRUE(support::says(refusal(path), "f:2: expected the whole file")) << path;
  }
  EXPECT_EQ(refusal(plain("c.gml", kPlain)), "");
  EXPECT_EQ(refusal(plain("d.geojson", "{\"a\":\"<!DOCTYPE\"}")), "");
}

}  // namespace
}  // namespace geom::gis
