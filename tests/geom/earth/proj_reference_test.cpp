#include "geom/earth/proj_reference.h"

#include <gtest/gtest.h>

#include <numbers>

namespace {

using geom::ProjReference;
using Kind = geom::CoordinateReference::Kind;

TEST(ProjReference, KnowsUnitsOfThePlaneAndOfHeights) {
  const auto feet = ProjReference::of("EPSG:2994+6360");
  ASSERT_TRUE(feet);
  EXPECT_EQ(feet->told().kind, Kind::metric);
  EXPECT_DOUBLE_EQ(*feet->told().plane, 0.3048);
  EXPECT_DOUBLE_EQ(*feet->told().up, 1200.0 / 3937);
  EXPECT_FALSE(ProjReference::of("EPSG:25832")->told().up);
  EXPECT_EQ(ProjReference::of("EPSG:4326")->told().kind, Kind::no_plane);
  EXPECT_EQ(ProjReference::of("EPSG:3857")->told().kind, Kind::no_plane);
  EXPECT_EQ(ProjReference::of("EPSG:4978")->told().kind, Kind::no_plane);
  EXPECT_TRUE(ProjReference::of("EPSG:3857")->places());
  EXPECT_FALSE(ProjReference::of("EPSG:4978")->places());
}

TEST(ProjReference, KnowsDepths) {
  EXPECT_TRUE(ProjReference::of("EPSG:32632+5715")->told().depths);
  EXPECT_FALSE(ProjReference::of("EPSG:32632+5714")->told().depths);
  EXPECT_FALSE(ProjReference::of("EPSG:25832")->told().depths);
}

TEST(ProjReference, KnowsWhatIsOneOfX) {
  EXPECT_EQ(ProjReference::of("EPSG:25832")->unit(), 1);
  EXPECT_EQ(ProjReference::of("EPSG:3857")->unit(), 1);
  EXPECT_DOUBLE_EQ(*ProjReference::of("EPSG:2263")->unit(), 1200.0 / 3937);
  EXPECT_DOUBLE_EQ(*ProjReference::of("EPSG:4326")->unit(), std::numbers::pi / 180);
  EXPECT_NEAR(*ProjReference::of("EPSG:4807")->unit(), std::numbers::pi / 200, 1e-15);  // grads
  EXPECT_TRUE(ProjReference::of("EPSG:4807")->is_geographic());
  EXPECT_FALSE(ProjReference::of("EPSG:25832")->is_geographic());
}

TEST(ProjReference, KnowsWhichAxisIsFirst) {
  for (const char* crs : {"EPSG:4326", "EPSG:4979", "EPSG:4807", "EPSG:31468", "EPSG:31468+5783",
                          "EPSG:2180", "EPSG:3035", "EPSG:2193", "EPSG:32661", "EPSG:32761"}) {
    EXPECT_TRUE(ProjReference::of(crs)->north_first()) << crs;
  }
  for (const char* crs : {"EPSG:25832", "EPSG:28992", "EPSG:27700", "EPSG:7415", "EPSG:3857",
                          "OGC:CRS84", "EPSG:5514", "EPSG:2065", "EPSG:2046", "EPSG:3031",
                          "EPSG:5041", "EPSG:5042", "+proj=longlat +datum=WGS84"}) {
    EXPECT_FALSE(ProjReference::of(crs)->north_first()) << crs;
  }
}

TEST(ProjReference, KnowsWhereASystemIsMeantFor) {
  const auto dutch = ProjReference::of("EPSG:28992")->area();
  ASSERT_TRUE(dutch);
  EXPECT_NEAR(dutch->west, 3.2, 0.1);
  EXPECT_NEAR(dutch->north, 53.7, 0.1);
  EXPECT_EQ(ProjReference::of("EPSG:25832+5783")->area()->west,
            ProjReference::of("EPSG:25832")->area()->west);
  EXPECT_FALSE(ProjReference::of("+proj=utm +zone=33 +datum=WGS84")->area());
}

// 2171 has its false easting wrong, and 3120 replaced it.
TEST(ProjReference, TakesTheCodeThatReplacedAnother) {
  EXPECT_EQ(ProjReference::of("EPSG:31467")->told().name, "DHDN / 3-degree Gauss-Kruger zone 3");
  EXPECT_EQ(ProjReference::of("EPSG:2171")->told().name,
            ProjReference::of("EPSG:3120")->told().name);
}

// As GDAL gives that of EPSG:28992, with another name or another easting.
std::string dutch(const std::string& name, const std::string& easting) {
  return "PROJCS[\"" + name + R"(",GEOGCS["Amersfoort",DATUM["Amersfoort",
      SPHEROID["Bessel 1841",6377397.155,299.1528128,AUTHORITY["EPSG","7004"]],
      AUTHORITY["EPSG","6289"]],PRIMEM["Greenwich",0,AUTHORITY["EPSG","8901"]],
      UNIT["degree",0.0174532925199433,AUTHORITY["EPSG","9122"]],AUTHORITY["EPSG","4289"]],
      PROJECTION["Oblique_Stereographic"],PARAMETER["latitude_of_origin",52.1561605555556],
      PARAMETER["central_meridian",5.38763888888889],PARAMETER["scale_factor",0.9999079],
      PARAMETER["false_easting",)" +
         easting + R"(],PARAMETER["false_northing",463000],
      UNIT["metre",1,AUTHORITY["EPSG","9001"]],AXIS["Easting",EAST],AXIS["Northing",NORTH],
      AUTHORITY["EPSG","28992"]])";
}

TEST(ProjReference, KnowsWhereWellKnownTextWithACodeIsMeantFor) {
  EXPECT_TRUE(ProjReference::of(dutch("Amersfoort / RD New", "155000"))->area());
  EXPECT_FALSE(ProjReference::of(dutch("Amersfoort / RD New", "155001"))->area());
}

// Its own numbers count, whatever became of its code.
TEST(ProjReference, ObeysWellKnownTextOfADeprecatedSystem) {
  const std::string name = "Amersfoort / RD New (deprecated)";
  EXPECT_TRUE(ProjReference::of(dutch(name, "1"))->told().name.starts_with("Amersfoort / RD New"));
}

TEST(ProjReference, UnderstandsTheFormsThatFilesHave) {
  for (const char* text :
       {"urn:ogc:def:crs:EPSG::28992", "http://www.opengis.net/def/crs/EPSG/0/28992",
        "https://www.opengis.net/def/crs/EPSG/0/28992", "epsg:28992", "+init=epsg:28992",
        "Amersfoort / RD New", "amersfoort/rd new"}) {
    const auto system = ProjReference::of(text);
    ASSERT_TRUE(system) << text;
    EXPECT_EQ(system->told().name, "Amersfoort / RD New") << text;
  }
  EXPECT_EQ(ProjReference::of("WGS84")->told().name, "WGS 84");
}

TEST(ProjReference, IsNothingOfOtherText) {
  for (const char* text : {"", "Oregon", "Amersfoort / RD", "EPSG:1", "EPSG:28992abc",
                           "PROJCS[\"a\"", "GeoTIFF keys: user-defined"}) {
    EXPECT_FALSE(ProjReference::of(text)) << text;
  }
}

}  // namespace
