#include "gis/gdal_reference.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "geom/gis/footprint_source.h"
#include "support/memory_file.h"
#include "support/reading.h"
#include "support/shape_files.h"

namespace geom::gis {
namespace {

using support::refusal_of;
using support::says;

constexpr const char* kUnknown = "expected a coordinate reference system that PROJ knows";

std::string refusal(const std::string& name, const std::string& text) {
  return refusal_of([&] { read_text(name, text, {}); });
}

// Of a shapefile whose .prj says so.
std::string refusal_of_prj(const std::string& text) {
  const ShapeFiles files;
  write_layer("ESRI Shapefile", files.shp.path(), {{{{0, 0}, {9, 0}, {9, 9}}, {0, 0, 0}, 5}});
  const MemoryFile prj("city.prj", text);
  return refusal_of([&] { read_vector(files.shp.path(), "city.shp", {}); });
}

// As if there were none, a file in feet would count as one in metres.
TEST(RequireKnownReferences, RefusesAPrjThatIsNotUnderstood) {
  EXPECT_EQ(refusal_of_prj(" \r\n"), "");
  EXPECT_EQ(refusal_of_prj("LOCAL_CS[\"site\",UNIT[\"metre\",1]]"), "");
  for (const char* text :
       {"EPSG:2263", R"({"type":"ProjectedCRS"})", R"(PROJCS["NAD83",GEOGCS[)"}) {
    EXPECT_TRUE(says(refusal_of_prj(text), kUnknown)) << text;
    EXPECT_TRUE(says(refusal_of_prj(text), "found a .prj that says")) << text;
  }
}

TEST(RequireKnownReferences, RefusesAPrjOfATableAndOfAGrid) {
  const MemoryFile of_table("table.prj", "feet");
  EXPECT_TRUE(says(refusal("table.csv", "WKT,height\n\"POLYGON((0 0,9 0,9 9,0 0))\",12\n"),
                   "found a .prj that says \"feet\""));
  const MemoryFile of_grid("grid.prj", "feet");
  const MemoryFile grid("grid.asc",
                        "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 5\n1 2\n3 4\n");
  EXPECT_TRUE(says(refusal_of([&] { read_raster(grid.path(), "grid.asc", {}); }),
                   "found a .prj that says \"feet\""));
}

std::string geojson(const std::string& of_file, const std::string& of_feature,
                    const std::string& of_geometry) {
  return fmt::format(
      R"({{"type":"FeatureCollection",{}"features":[{{"type":"Feature",{}"properties":{{"height":9}},)"
      R"("geometry":{{"type":"Polygon",{}"coordinates":[[[0,0],[9,0],[9,9],[0,0]]]}}}}]}})",
      of_file, of_feature, of_geometry);
}

std::string crs(const char* name) {
  return fmt::format(R"("crs":{{"type":"name","properties":{{"name":"{}"}}}},)", name);
}

TEST(RequireKnownReferences, RefusesAGeoJsonCrsThatIsNotObeyed) {
  for (const char* name : {"urn:ogc:def:crs:OGC:1.3:CRS84", "EPSG:25832"}) {
    EXPECT_EQ(refusal("a.geojson", geojson(crs(name), "", "")), "") << name;
  }
  EXPECT_TRUE(says(refusal("a.geojson", geojson(crs("urn:x:site"), "", "")), kUnknown));
  for (const char* other :
       {R"("crs":null,)", R"("crs":{"type":"link","properties":{"href":"a"}},)"}) {
    EXPECT_TRUE(says(refusal("a.geojson", geojson(other, "", "")),
                     "expected the name of a coordinate reference system"))
        << other;
  }
  EXPECT_TRUE(says(refusal("a.geojson", geojson("", crs("EPSG:4267"), "")),
                   "feature 0: expected a \"crs\" of the whole file alone"));
  EXPECT_TRUE(says(refusal("a.geojson", geojson("", "", crs("EPSG:4267"))),
                   "expected the coordinate reference system of its layer, found another"));
}

std::string esri(const std::string& of_file, const std::string& of_geometry) {
  return fmt::format(
      R"({{"geometryType":"esriGeometryPolygon","fields":[{{"name":"height","alias":"height",)"
      R"("type":"esriFieldTypeDouble"}}],{}"features":[{{"attributes":{{"height":9}},)"
      R"("geometry":{{{}"rings":[[[0,0],[0,9],[9,9],[0,0]]]}}}}]}})",
      of_file, of_geometry);
}

TEST(RequireKnownReferences, RefusesAnEsriSystemThatIsNotObeyed) {
  const std::string utm = R"("spatialReference":{"wkid":25832},)";
  EXPECT_EQ(refusal("a.json", esri("", "")), "");
  EXPECT_EQ(refusal("a.json", esri(utm, utm)), "");
  EXPECT_TRUE(
      says(refusal("a.json", esri(R"("spatialReference":{"wkid":999999},)", "")), kUnknown));
  EXPECT_TRUE(says(refusal("a.json", esri("", utm)),
                   "feature 0: expected the \"spatialReference\" of the file"));
  EXPECT_TRUE(says(refusal("a.json", esri(utm, R"("spatialReference":{"wkid":2263},)")),
                   "feature 0: expected the \"spatialReference\" of the file"));
}

TEST(RequireWhole, RefusesArcsOfEsri) {
  EXPECT_TRUE(says(refusal("a.json", esri("", R"("curveRings":[[[20,0],{"c":[[25,0],[22,3]]}]],)")),
                   "feature 0: expected rings, found \"curveRings\", which has arcs"));
}

std::string gml(const char* first, const char* second) {
  const auto member = [](const char* system) {
    return fmt::format(
        "<gml:featureMember><a:house><a:height>9</a:height><a:plan><gml:Polygon{}>"
        "<gml:outerBoundaryIs><gml:LinearRing><gml:coordinates>500000,0 500009,0 500009,9 500000,0"
        "</gml:coordinates></gml:LinearRing></gml:outerBoundaryIs></gml:Polygon></a:plan></a:house>"
        "</gml:featureMember>",
        system);
  };
  return "<a:C xmlns:a=\"a\" xmlns:gml=\"http://www.opengis.net/gml\">" + member(first) +
         member(second) + "</a:C>";
}

// GDAL gives none to the layer then, and both stood in one place.
TEST(RequireKnownReferences, RefusesGmlOfTwoSystems) {
  constexpr const char* kZone32 = " srsName=\"EPSG:25832\"";
  EXPECT_EQ(refusal("a.gml", gml(kZone32, kZone32)), "");
  EXPECT_TRUE(says(refusal("a.gml", gml(kZone32, " srsName=\"EPSG:25833\"")),
                   "expected one coordinate reference system in the file, found \"EPSG:25832\" and "
                   "\"EPSG:25833\""));
  EXPECT_TRUE(says(refusal("a.gml", gml(" srsName=\"site:1\"", "")), kUnknown));
}

}  // namespace
}  // namespace geom::gis
