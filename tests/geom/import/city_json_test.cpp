#include "geom/import/city_json.h"

#include <gtest/gtest.h>

#include <sstream>

#include "geom/import/city_footprints.h"
#include "support/refusal.h"

namespace geom {
namespace {

CityFootprints city(const std::string& objects, const std::string& more = "") {
  std::istringstream in(R"({"type":"CityJSON","version":"2.0","vertices":[[0,0,0],[9,0,0],[9,9,4],)"
                        R"([50,0,0],[59,0,0],[59,9,7],[100,200,5]],"CityObjects":)" +
                        objects + more + "}");
  return footprints_of(read_city_json(in, "city"), 1, {});
}

TEST(CityJson, TakesAllGeometriesOfTheHighestLevel) {
  const CityFootprints both =
      city(R"({"b":{"type":"Building","geometry":[)"
           R"({"type":"MultiSurface","lod":"1","boundaries":[[[0,1,5]]]},)"
           R"({"type":"MultiSurface","lod":"2","boundaries":[[[0,1,2]]]},)"
           R"({"type":"MultiSurface","lod":"2","boundaries":[[[3,4,5]]]}]}})");
  ASSERT_EQ(both.footprints.size(), 2u);
  EXPECT_EQ(both.footprints[0].top, 4);
  EXPECT_EQ(both.footprints[1].top, 7);
  EXPECT_EQ(both.footprints[0].id, both.footprints[1].id);
}

constexpr const char* kTree =
    R"({"t":{"type":"SolitaryVegetationObject","geometry":[{"type":"GeometryInstance",)"
    R"("template":0,"boundaries":[6],"transformationMatrix":[2,0,0,1,0,2,0,0,0,0,3,0,0,0,0,1]}]}})";

TEST(CityJson, PlacesTemplates) {
  const CityFootprints tree =
      city(kTree, R"(,"geometry-templates":{"templates":[{"type":"MultiSurface",)"
                  R"("lod":"2","boundaries":[[[0,1,2]]]}],"vertices-templates":)"
                  R"([[0,0,0],[1,0,0],[1,1,2]]})");
  ASSERT_EQ(tree.footprints.size(), 1u);
  EXPECT_EQ(tree.footprints[0].bottom, 5);
  EXPECT_EQ(tree.footprints[0].top, 11);
  EXPECT_EQ(tree.footprints[0].polygon.outer[0], Vec2(101, 200));
  EXPECT_EQ(tree.footprints[0].polygon.outer[2], Vec2(103, 202));
}

TEST(CityJson, RefusesATemplateThatIsNotThere) { EXPECT_ANY_THROW(city(kTree)); }

std::string crs_of(const std::string& named) {
  std::istringstream in(
      R"({"type":"CityJSON","version":"2.0","vertices":[[0,0,0],[9,0,0],[9,9,4]],)"
      R"("CityObjects":{"b":{"type":"Building","geometry":[{"type":"MultiSurface",)"
      R"("lod":"2","boundaries":[[[0,1,2]]]}]}},"metadata":{"referenceSystem":")" +
      named + R"("}})");
  return read_city_json(in, "t").crs;
}

TEST(CityJson, NamesItsReferenceSystemByItsCode) {
  EXPECT_EQ(crs_of("https://www.opengis.net/def/crs/EPSG/0/7415"), "EPSG:7415");
  EXPECT_EQ(crs_of("urn:ogc:def:crs:EPSG::7415"), "EPSG:7415");
}

// Of two systems the last is that of heights: its code alone would place nothing.
TEST(CityJson, NamesACompoundReferenceSystemAsTheFileDoes) {
  for (const char* named :
       {"https://www.opengis.net/def/crs-compound?1=https://www.opengis.net/def/"
        "crs/EPSG/0/28992&2=https://www.opengis.net/def/crs/EPSG/0/5709",
        "urn:ogc:def:crs,crs:EPSG::28992,crs:EPSG::5709"}) {
    EXPECT_EQ(crs_of(named), named);
  }
}

// Objects over four points of a slope, the last of them at the origin.
CityFootprints on_a_slope(const std::string& objects) {
  std::istringstream in(R"({"type":"CityJSON","version":"2.0","CityObjects":{)" + objects +
                        R"(},"vertices":[[0,0,5],[9,0,7],[0,9,6],[9,9,8],[0,0,0]]})");
  return footprints_of(read_city_json(in, "t"), 1, {});
}

TEST(CityJson, TerrainIsGroundAndBuilt) {
  const auto out = on_a_slope(
      R"("t":{"type":"TINRelief","geometry":[{"type":"CompositeSurface","lod":"1","boundaries":[[[0,1,2]],[[1,3,2]]]}]})");
  ASSERT_EQ(out.footprints.size(), 2u);
  EXPECT_TRUE(out.footprints[0].ground);
  EXPECT_EQ(out.footprints[1].bottom, 5);
  EXPECT_EQ(out.footprints[1].top, 8);
}

TEST(CityJson, ObjectsWithoutSurfacesAreSkippedUnlessTheirChildrenHaveThem) {
  const std::string part =
      R"("p":{"type":"BuildingPart","geometry":[{"type":"MultiSurface","lod":"1","boundaries":[[[0,1,2]]]}]})";
  EXPECT_EQ(on_a_slope(R"("b":{"type":"Building","children":["p"]},)" + part).skipped.count(), 0u);
  EXPECT_EQ(on_a_slope(R"("b":{"type":"Building"},)" + part).skipped.count(), 1u);
  EXPECT_EQ(
      on_a_slope(
          R"("b":{"type":"Bridge","geometry":[{"type":"MultiPoint","lod":"1","boundaries":[0]}]},)" +
          part)
          .skipped.count(),
      1u);
  EXPECT_EQ(on_a_slope(R"("r":{"type":"Road"},)" + part).skipped.count(), 0u);
}

std::string refusal_of_city(const std::string& transform, const std::string& matrix,
                            const std::string& version = "2.0") {
  return support::refusal_of([&] {
    std::istringstream in(
        R"({"type":"CityJSON","version":")" + version + R"(","transform":)" + transform +
        R"(,"vertices":[[0,0,0],[9,0,0],[9,9,4]],"CityObjects":{"t":{"type":"Building","geometry":[)"
        R"({"type":"GeometryInstance","template":0,"boundaries":[0],"transformationMatrix":)" +
        matrix +
        R"(}]}},"geometry-templates":{"templates":[{"type":"MultiSurface","lod":"2",)"
        R"("boundaries":[[[0,1,2]]]}],"vertices-templates":[[0,0,0],[1,0,0],[1,1,2]]}})");
    read_city_json(in, "t");
  });
}

TEST(CityJson, RefusesScalesAndMatricesThatLoseWhatTheyPlace) {
  const std::string scale = R"({"scale":[1,1,1],"translate":[0,0,0]})";
  const std::string same = "[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]";
  EXPECT_EQ(refusal_of_city(scale, same), "");
  EXPECT_NE(refusal_of_city(R"({"scale":[1,1,0],"translate":[0,0,0]})", same), "");
  EXPECT_NE(refusal_of_city(scale, "[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,2]"), "");
  EXPECT_NE(refusal_of_city(scale, "[1,0,0,0,0,1,0,0,0,0,1,0,0.1,0,0,1]"), "");
  EXPECT_NE(refusal_of_city(scale, "[1,0,0,0,0,1,0,0,0,0,0,0,0,0,0,1]"), "");
  EXPECT_NE(refusal_of_city(scale, same, "2.7"), "");
  EXPECT_EQ(refusal_of_city(scale, same, "1.0.3"), "");
}

}  // namespace
}  // namespace geom
