#include <fmt/format.h>
#include <gtest/gtest.h>

#include "geom/base/error.h"
#include "geom/gis/footprint_source.h"
#include "support/memory_file.h"
#include "support/reading.h"
#include "support/shape_files.h"
#include "support/temporary_folder.h"

namespace geom::gis {
namespace {

using support::refusal_of;
using support::says;

// One square of 9 m whose corners have these heights.
Source read_square(double west, double east, const std::string& properties,
                   const ReadOptions& options = {}) {
  const std::string ring =
      fmt::format("[[0,0,{0}],[9,0,{1}],[9,9,{1}],[0,9,{0}],[0,0,{0}]]", west, east);
  return read_geojson(
      fmt::format(R"({{"type":"Feature","properties":{{{}}},"geometry":{{"type":"Polygon",)"
                  R"("coordinates":[{}]}}}})",
                  properties, ring),
      options);
}

TEST(ReadVector, AddsTheHeightToCornersThatSlope) {
  const Source source = read_square(40, 47, R"("height":19)");
  ASSERT_EQ(source.footprints.size(), 1u);
  EXPECT_EQ(source.footprints[0].bottom, 0);
  EXPECT_EQ(source.footprints[0].top, 66);
  EXPECT_EQ(source.counts.at("heights_given"), 1u);
}

TEST(ReadVector, ReachesDownToTheLowestCorner) {
  const Source source = read_square(-3, 4, R"("height":19)");
  EXPECT_EQ(source.footprints.at(0).bottom, -3);
  EXPECT_EQ(source.footprints.at(0).top, 23);
}

TEST(ReadVector, SlopesLikeWhatIsLevel) {
  const double level = read_square(40, 40, R"("height":19)").footprints.at(0).top;
  const double sloped = read_square(40, 40.01, R"("height":19)").footprints.at(0).top;
  EXPECT_NEAR(level, sloped, 0.02);
}

TEST(ReadVector, CountsTheNamedAttributeOnASlope) {
  ReadOptions options;
  options.height.attribute = "h_max";
  EXPECT_EQ(read_square(40, 47, R"("h_max":19)", options).footprints.at(0).top, 66);
}

// Fields whose names differ in their case alone are one attribute.
TEST(ReadVector, TakesTheHighestOfFieldsOfOneName) {
  const auto top = [](const std::string& properties) {
    return read_square(0, 0, properties).footprints.at(0).top;
  };
  EXPECT_EQ(top(R"("HEIGHT":3,"height":50)"), 50);
  EXPECT_EQ(top(R"("height":3,"HEIGHT":50)"), 50);
  EXPECT_EQ(top(R"("height":3,"Building:Height":50)"), 50);
  EXPECT_EQ(top(R"("Building:Levels":2,"building:levels":9)"), 27);
  EXPECT_EQ(top(R"("HEIGHT":null,"height":50)"), 50);
  EXPECT_EQ(top(R"("HEIGHT":"","height":50)"), 50);
  const Source unread = read_square(0, 0, R"("HEIGHT":"tall","height":50)");
  EXPECT_EQ(unread.skipped.count(), 1u);
}

TEST(ReadVector, TakesTheLowestBottomOfFieldsOfOneName) {
  const Source source = read_square(0, 0, R"("height":50,"MIN_HEIGHT":9,"min_height":4)");
  EXPECT_EQ(source.footprints.at(0).bottom, 4);
}

TEST(ReadVector, TakesTheNamedAttributeInAnyCase) {
  ReadOptions options;
  options.height.attribute = "H_max";
  EXPECT_EQ(read_square(0, 0, R"("h_max":19,"H_MAX":31)", options).footprints.at(0).top, 31);
}

TEST(ReadVector, TakesWhicheverFieldAFeatureHas) {
  const auto feature = [](const char* height) {
    return fmt::format(R"({{"type":"Feature","properties":{{{}}},"geometry":{{"type":"Polygon",)"
                       R"("coordinates":[[[0,0],[9,0],[9,9],[0,0]]]}}}})",
                       height);
  };
  const Source source =
      read_geojson(fmt::format(R"({{"type":"FeatureCollection","features":[{},{}]}})",
                               feature(R"("Height":12)"), feature(R"("height":200)")),
                   {});
  EXPECT_EQ(source.footprints.at(0).top, 12);
  EXPECT_EQ(source.footprints.at(1).top, 200);
}

TEST(ReadVector, TakesTheHighestOfColumnsOfOneName) {
  const Source source = read_text("city.csv",
                                  "WKT,height,height,Height\n"
                                  "\"POLYGON((0 0,9 0,9 9,0 0))\",3,50,40\n",
                                  {});
  EXPECT_EQ(source.footprints.at(0).top, 50);
}

TEST(ReadVector, TellsTheDefaultOfASlopeWithoutAHeight) {
  const Source source = read_square(40, 47, R"("use":"flats")");
  EXPECT_EQ(source.footprints.at(0).top, 57);
  EXPECT_EQ(source.counts.at("heights_by_default"), 1u);
  EXPECT_EQ(source.defaults.count(), 1u);
}

// A roof and a wall below it.
std::string solid(const std::string& properties) {
  return fmt::format(
      R"({{"type":"Feature","properties":{{{}}},"geometry":{{"type":"MultiPolygon","coordinates":[)"
      R"([[[0,0,47],[9,0,47],[9,9,47],[0,9,47],[0,0,47]]],)"
      R"([[[0,0,40],[9,0,40],[9,0,47],[0,0,47],[0,0,40]]]]}}}})",
      properties);
}

TEST(ReadVector, BelievesTheWallsOfASolid) {
  const Source source = read_geojson(solid(""), {});
  ASSERT_EQ(source.footprints.size(), 2u);
  EXPECT_EQ(source.footprints[0].bottom, 0);
  EXPECT_EQ(source.footprints[0].top, 47);
  EXPECT_EQ(source.counts.at("heights_from_corners"), 1u);
}

TEST(ReadVector, RaisesASolidThatIsHigherThanItsWalls) {
  EXPECT_EQ(read_geojson(solid(R"("height":19)"), {}).footprints.at(0).top, 59);
  EXPECT_EQ(read_geojson(solid(R"("height":5)"), {}).footprints.at(0).top, 47);
}

TEST(ReadVector, TakesATruthForNoHeight) {
  const Source source = read_square(0, 0, R"("height":true)");
  EXPECT_EQ(source.counts.at("heights_by_default"), 1u);
  EXPECT_EQ(source.skipped.count(), 1u);
}

TEST(ReadVector, SkipsATowerWithoutAHeight) {
  const Source source = read_square(0, 0, R"("man_made":"tower")");
  EXPECT_EQ(source.footprints.size(), 1u);
  EXPECT_NE(source.skipped.text().find("1 x tower, mast or the like without a height"),
            std::string::npos);
  EXPECT_TRUE(read_square(0, 0, R"("man_made":"tower","height":80)").skipped.empty());
}

// Chords of arcs leave out what is between them and the arc.
TEST(ReadVector, HoldsArcsWithinTheBulge) {
  const auto read = [](const std::string& wkt) {
    return read_text("city.csv", "WKT,height\n\"" + wkt + "\",9\n", {}).footprints.at(0);
  };
  const Footprint circle =
      read("CURVEPOLYGON(CIRCULARSTRING(1000 0,0 1000,-1000 0,0 -1000,1000 0))");
  double gap = 0;
  const auto& ring = circle.polygon.outer;
  for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
    gap = std::max(gap, 1000 - (0.5 * (ring[i] + ring[i + 1])).norm());
  }
  EXPECT_GT(gap, 0.005);
  EXPECT_LE(gap, circle.bulge);
  EXPECT_LT(circle.bulge, 0.04);
  EXPECT_DOUBLE_EQ(read("CURVEPOLYGON(CIRCULARSTRING(-1000 0,1000 0,-1000 0))").bulge,
                   circle.bulge);
  const double flat =
      read("CURVEPOLYGON(COMPOUNDCURVE(CIRCULARSTRING(0 0,50 0.01,100 0),(100 0,50 90,0 0)))")
          .bulge;
  EXPECT_GE(flat, 0.0099);
  EXPECT_LE(flat, 0.0101);
  EXPECT_EQ(read("POLYGON((0 0,9 0,9 9,0 0))").bulge, 0);
}

TEST(RequireAttribute, RefusesANameThatNothingHas) {
  ReadOptions options;
  options.height.attribute = "h_max";
  EXPECT_NO_THROW(
      require_attribute(read_square(0, 0, R"("h_max":19)", options), options, "x.geojson"));
  EXPECT_THROW(require_attribute(read_square(0, 0, R"("h":19)", options), options, "x.geojson"),
               geom::InputError);
}

// QGIS keeps the styles of layers in such a table, which has no reference system.
TEST(ReadVector, PassesOverTheTableOfStylesOfQgis) {
  const support::TemporaryFolder folder;
  const std::string path = folder / "city.gpkg";
  write_layer("GPKG", path, {{{{0, 0}, {9, 0}, {9, 9}}, {0, 0, 0}, 5}});
  const auto add = [&](const char* table) {
    GDALDataset* const made = static_cast<GDALDataset*>(
        GDALOpenEx(path.c_str(), GDAL_OF_UPDATE, nullptr, nullptr, nullptr));
    OGRLayer* const layer = made->CreateLayer(table, nullptr, wkbNone, nullptr);
    OGRFeature row(layer->GetLayerDefn());
    EXPECT_EQ(layer->CreateFeature(&row), OGRERR_NONE);
    GDALClose(made);
  };
  add("layer_styles");
  const Source source = read_vector(path, path, {});
  EXPECT_EQ(source.footprints.size(), 1u);
  EXPECT_TRUE(source.skipped.empty());
  add("heights");
  EXPECT_TRUE(
      says(refusal_of([&] { read_vector(path, path, {}); }), "another in layer \"heights\""));
}

// In Esri's formats the direction tells a hole, whatever is within what.
TEST(ReadVector, ARingOfEsriThatTurnsClockwiseIsNoHole) {
  const auto read = [](const std::string& inner) {
    return read_text("rings.json",
                     R"({"geometryType":"esriGeometryPolygon","fields":[{"name":"height",)"
                     R"("type":"esriFieldTypeDouble"}],"features":[{"attributes":{"height":9},)"
                     R"("geometry":{"rings":[[[0,0],[0,9],[9,9],[9,0],[0,0]],)" +
                         inner + "]}}]}",
                     ReadOptions{});
  };
  const Source hole = read("[[3,3],[6,3],[6,6],[3,6],[3,3]]");
  ASSERT_EQ(hole.footprints.size(), 1u);
  EXPECT_FALSE(contains(hole.footprints[0].polygon, {5, 5}));
  const Source solid = read("[[3,3],[3,6],[6,6],[6,3],[3,3]]");
  ASSERT_EQ(solid.footprints.size(), 2u);
  EXPECT_TRUE(contains(solid.footprints[0].polygon, {5, 5}));
  EXPECT_EQ(solid.footprints[1].top, 9);
}

// Its numbers are whole there, so GDAL cuts them.
TEST(ReadVector, TellsWhatGdalWarnsOf) {
  const MemoryFile types("typed.csvt", "WKT,Integer\n");
  const Source source =
      read_text("typed.csv", "WKT,number\n\"POLYGON((0 0,9 0,9 9,0 0))\",10.9\n", ReadOptions{});
  ASSERT_FALSE(source.warnings.empty());
  EXPECT_TRUE(source.warnings.front().starts_with("GDAL warns: "));
  EXPECT_TRUE(read_square(0, 0, R"("height":9)").warnings.empty());
}

}  // namespace
}  // namespace geom::gis
