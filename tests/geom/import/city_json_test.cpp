#include "import/city_json.h"

#include <gtest/gtest.h>

#include <sstream>

#include "import/city_footprints.h"
#include "support/reading.h"

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
           R"({"type":"MultiSurface","lod":"1","boundaries":[[[0,1,2]]]},)"
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

TEST(CityJson, TakesTheHighestOfAttributesOfOneName) {
  const CityFootprints out =
      city(R"({"B":{"type":"Building","attributes":{"MeasuredHeight":50,"measuredHeight":3},)"
           R"("geometry":[{"type":"MultiSurface","lod":"0","boundaries":[[[0,1,3]]]}]}})");
  EXPECT_EQ(out.footprints.at(0).top, 50);
}

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

// A code of another list is another system.
TEST(CityJson, NamesAReferenceSystemOfAnotherListAsTheFileDoes) {
  const std::string named = "https://www.opengis.net/def/crs/IGNF/1/4326";
  EXPECT_EQ(crs_of(named), named);
}

TEST(CityJson, RefusesAReferenceSystemThatIsNoText) {
  std::istringstream in(
      R"({"type":"CityJSON","version":"2.0","vertices":[[0,0,0],[9,0,0],[9,9,4]],)"
      R"("CityObjects":{"b":{"type":"Building","geometry":[{"type":"MultiSurface",)"
      R"("lod":"2","boundaries":[[[0,1,2]]]}]}},"metadata":{"referenceSystem":7415}})");
  EXPECT_THROW(read_city_json(in, "t"), InputError);
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

TEST(CityJson, CountsWhatIsNamedAndNotThere) {
  const std::string geometry =
      R"("geometry":[{"type":"MultiSurface","lod":"1","boundaries":[[[0,1,2]]]}])";
  for (const char* key : {"children", "members", "parents"}) {
    EXPECT_EQ(on_a_slope(R"("b":{"type":"Building",")" + std::string(key) + R"(":["p"],)" +
                         geometry + "}")
                  .skipped.count(),
              1u);
  }
}

std::string refusal(const std::string& text) {
  return support::refusal_of([&] {
    std::istringstream in(text);
    read_city_json(in, "t");
  });
}

TEST(CityJson, RefusesAScaleOfZero) {
  EXPECT_NE(refusal(R"({"type":"CityJSON","version":"2.0","CityObjects":{},"vertices":[],)"
                    R"("transform":{"scale":[1,0,1],"translate":[0,0,0]}})")
                .find("other than 0, found [1,0,1]"),
            std::string::npos);
}

// What is said of a template that is placed by this matrix.
std::string refusal_of_matrix(const std::string& numbers) {
  const std::string key = R"("transformationMatrix":[)";
  std::string tree(kTree);
  const std::size_t at = tree.find(key) + key.size();
  tree.replace(at, tree.find(']', at) - at, numbers);
  return refusal(R"({"type":"CityJSON","version":"2.0","vertices":[[0,0,0],[9,0,0],[9,9,4],)"
                 R"([50,0,0],[59,0,0],[59,9,7],[100,200,5]],"CityObjects":)" +
                 tree +
                 R"(,"geometry-templates":{"templates":[{"type":"MultiSurface","lod":"2",)"
                 R"("boundaries":[[[0,1,2]]]}],"vertices-templates":[[0,0,0],[1,0,0],[1,1,2]]}})");
}

TEST(CityJson, RefusesATemplateInPerspectiveOrOfNoVolume) {
  for (const auto& [numbers, said] :
       {std::pair{"1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,2",
                  "the last row of a transformationMatrix must be 0 0 0 1, found [0,0,0,2]"},
        {"1,0,0,0,0,1,0,0,0,0,0,0,0,0,0,1", "found one of volume 0"}}) {
    EXPECT_NE(refusal_of_matrix(numbers).find(said), std::string::npos) << numbers;
  }
}

TEST(CityJson, RefusesAVersionThatIsNotKnown) {
  EXPECT_NE(refusal(R"({"type":"CityJSON","version":"2.10","CityObjects":{},"vertices":[]})")
                .find("expected CityJSON version 1.0, 1.1 or 2.0, found"),
            std::string::npos);
}

const std::string kFirst =
    R"({"type":"CityJSON","version":"2.0","CityObjects":{},"vertices":[],)"
    R"("transform":{"scale":[0.5,0.5,1],"translate":[10,20,0]},)"
    R"("metadata":{"referenceSystem":"https://www.opengis.net/def/crs/EPSG/0/7415"}})";

std::string feature(const std::string& id, const std::string& more = "") {
  return R"({"type":"CityJSONFeature","id":")" + id + R"(",)" + more + R"("CityObjects":{")" + id +
         R"(":{"type":"Building","geometry":[{"type":"MultiSurface","lod":"2","boundaries":)"
         R"([[[0,1,2]]]}]}},"vertices":[[0,0,0],[18,0,0],[18,18,4]]})";
}

TEST(CityJsonSequence, HasOneTransformAndVerticesOfEachFeature) {
  std::istringstream in(kFirst + "\r\n" + feature("a") + "\n\n" + feature("a"));
  const CityModel model = read_city_json(in, "t");
  EXPECT_EQ(model.crs, "EPSG:7415");
  ASSERT_EQ(model.objects.size(), 2u);
  EXPECT_EQ(model.objects[1].geometries.at(0).surfaces[0][0][2], Vec3(19, 29, 4));
  EXPECT_NE(model.objects[0].whole, model.objects[1].whole);  // two of a name
  EXPECT_TRUE(model.skipped.empty());
}

TEST(CityJsonSequence, RefusesWhatWouldMoveOrHideFeatures) {
  const auto says = [](const std::string& text, const char* words) {
    return refusal(text).find(words) != std::string::npos;
  };
  EXPECT_TRUE(says(feature("a") + "\n" + feature("b"), "expected a first line"));
  EXPECT_TRUE(says(feature("a"), "expected a first line"));
  EXPECT_TRUE(says(kFirst + "\n" + kFirst + "\n" + feature("a"), "t:2: expected"));
  EXPECT_TRUE(says(kFirst + "\n" + feature("a") + "\n[]", "t:3: expected"));
  EXPECT_TRUE(says(kFirst + "\n" + feature("a", R"("transform":{},)"), "in the first line alone"));
  EXPECT_TRUE(says(R"({"type":"CityJSON","version":"2.0","CityObjects":{},"vertices":[]})"
                   "\n" +
                       feature("a"),
                   "transform"));
  EXPECT_TRUE(says(kFirst + "\n" + feature("a").substr(0, 60), "t:2"));
}

TEST(CityJsonSequence, CountsAFeatureThatIsNotInItself) {
  std::string text = feature("a");
  text.replace(text.find(R"("id":"a")"), 8, R"("id":"b")");
  std::istringstream in(kFirst + "\n" + text);
  EXPECT_EQ(read_city_json(in, "t").skipped.count(), 1u);
}

}  // namespace
}  // namespace geom
