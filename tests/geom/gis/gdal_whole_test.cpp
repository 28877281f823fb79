#include "gis/gdal_whole.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "geom/gis/footprint_source.h"
#include "support/reading.h"
#include "support/shape_files.h"
#include "support/temporary_folder.h"

namespace geom::gis {
namespace {

using support::says;

const std::string kFeature =
    R"({"type":"Feature","properties":{"height":9},"geometry":{"type":"Polygon",)"
    R"("coordinates":[[[0,0],[9,0],[9,9],[0,0]]]}})";

std::string collection(const std::string& members) {
  return R"({"type":"FeatureCollection",)" + members + R"("features":[)" + kFeature + "]}";
}

// What reading the text says against it; empty where it is read.
std::string refusal(const std::string& name, const std::string& text) {
  return support::refusal_of([&] { read_text(name, text, {}); });
}

TEST(RequireWhole, RefusesGeoJsonThatItsServerCut) {
  for (const char* members :
       {R"("exceededTransferLimit":true,)", R"("properties":{"exceededTransferLimit":true},)",
        R"("numberMatched":9,"numberReturned":1,)", R"("numberMatched":9,)",
        R"("totalFeatures":2,)", R"("links":[{"rel":"self"},{"rel":"next","href":"x"}],)"}) {
    EXPECT_TRUE(says(refusal("a.geojson", collection(members)), "a part of what its server has"))
        << members;
  }
  for (const char* members :
       {"", R"("exceededTransferLimit":false,)", R"("numberMatched":1,"numberReturned":1,)",
        R"("numberMatched":"unknown",)", R"("links":[{"rel":"self"}],"totalFeatures":1,)"}) {
    EXPECT_EQ(refusal("a.geojson", collection(members)), "") << members;
  }
}

TEST(FilesBeside, AreTheOtherPartsOfAShapefile) {
  const support::TemporaryFolder folder;
  const std::string path = folder / "city.shp";
  write_layer("ESRI Shapefile", path, {{{{0, 0}, {9, 0}, {9, 9}}, {0, 0, 0}, 5}});
  const std::vector<std::string> beside = read_vector(path, path, {}).beside;
  EXPECT_EQ(std::count(beside.begin(), beside.end(), folder / "city.dbf"), 1);
  EXPECT_EQ(std::count(beside.begin(), beside.end(), folder / "city.shx"), 1);
  EXPECT_EQ(std::count(beside.begin(), beside.end(), path), 0);
}

TEST(RequireWhole, RefusesAKeyThatComesTwice) {
  EXPECT_TRUE(
      says(refusal("a.geojson", collection(R"("features":[],)")), "expected each key once"));
  std::string twice = collection("");
  twice.replace(twice.find(R"("height":9)"), 10, R"("height":9,"height":2)");
  EXPECT_TRUE(says(refusal("a.geojson", twice), "found \"height\" again"));
}

// GDAL reads a "feature" and leaves out its attributes.
TEST(RequireWhole, RefusesGeoJsonInOtherLetters) {
  std::string odd = collection("");
  odd.replace(odd.rfind("\"Feature\""), 9, "\"feature\"");
  EXPECT_TRUE(says(refusal("a.geojson", odd), "feature 0: expected \"type\" to be Feature"));
  odd = collection("");
  odd.replace(odd.find("FeatureCollection"), 17, "featurecollection");
  EXPECT_NE(refusal("a.geojson", odd), "");
}

// Its solid would be left out.
TEST(RequireWhole, RefusesAPlaceOfJsonFg) {
  const auto with = [](const std::string& place) {
    std::string text = collection("");
    text.replace(text.find(R"("properties")"), 0, R"("place":)" + place + ",");
    return refusal("a.geojson", text);
  };
  EXPECT_EQ(with("null"), "");
  EXPECT_TRUE(says(with(R"({"type":"Prism","lower":0,"upper":80})"),
                   "feature 0: expected its shape as \"geometry\", found a \"place\""));
}

TEST(RequireWhole, LooksAtEachLineOfASequence) {
  const std::string lines = kFeature + "\n" + kFeature + "\n";
  EXPECT_EQ(refusal("a.geojsonl", lines), "");
  std::string twice = lines;
  twice.replace(twice.rfind(R"("height":9)"), 10, R"("height":9,"height":2)");
  EXPECT_TRUE(says(refusal("a.geojsonl", twice), ":2: column"));
}

std::string kml(const std::string& more) {
  return R"(<?xml version="1.0"?><kml xmlns="http://www.opengis.net/kml/2.2"><Document><Placemark>)"
         "<Polygon><outerBoundaryIs><LinearRing><coordinates>0,0,5 1,0,5 1,1,5 0,0,5</coordinates>"
         "</LinearRing></outerBoundaryIs></Polygon></Placemark>" +
         more + "</Document></kml>";
}

TEST(RequireWhole, RefusesKmlThatLeadsElsewhere) {
  EXPECT_EQ(refusal("a.kml", kml("")), "");
  EXPECT_TRUE(
      says(refusal("a.kml", kml("<NetworkLink><Link><href>rest.kml</href></Link></NetworkLink>")),
           "found a NetworkLink"));
  EXPECT_TRUE(says(refusal("a.kml", kml("<Placemark><Model><Link><href>t.dae</href></Link></Model>"
                                        "</Placemark>")),
                   "found a Model"));
}

TEST(RequireWhole, RefusesOpenStreetMapWithoutItsHeights) {
  EXPECT_TRUE(says(refusal("a.osm", R"(<osm version="0.6"><node id="1" lat="1" lon="2"/></osm>)"),
                   "--format osm"));
}

class Shapefile : public testing::Test {
 protected:
  Shapefile() {
    const std::vector<geom::Vec2> square{{0, 0}, {9, 0}, {9, 9}, {0, 9}};
    write_layer("ESRI Shapefile", files_.shp.path(),
                {{square, {0, 0, 0, 0}, 5}, {square, {0, 0, 0, 0}, 6}, {square, {0, 0, 0, 0}, 7}});
  }

  std::string refusal() const {
    return support::refusal_of([&] { read_vector(files_.shp.path(), "city.shp", {}); });
  }

  static void change(const MemoryFile& file, std::size_t at, char to) {
    std::string bytes = file.read();
    bytes.at(at) = to;
    file.write(bytes);
  }

  ShapeFiles files_;
};

TEST_F(Shapefile, IsReadWhereItsFilesAgree) { EXPECT_EQ(refusal(), ""); }

TEST_F(Shapefile, IsRefusedWithARowMarkedAsDeleted) {
  const std::string bytes = files_.dbf.read();
  const std::size_t first = static_cast<unsigned char>(bytes[8]);
  const std::size_t size = static_cast<unsigned char>(bytes[10]);
  change(files_.dbf, first + size, '*');
  EXPECT_TRUE(says(refusal(), "row 2 of its table is marked as deleted"));
}

TEST_F(Shapefile, IsRefusedWhereTheTableHasOtherRows) {
  change(files_.dbf, 4, 2);
  EXPECT_TRUE(says(refusal(), "expected a row for each of the 3 shapes of city.dbf, found 2"));
}

TEST_F(Shapefile, IsRefusedWhereTheTableIsCut) {
  files_.dbf.write(files_.dbf.read().substr(0, files_.dbf.read().size() - 20));
  EXPECT_TRUE(says(refusal(), "do not belong together"));
}

TEST_F(Shapefile, IsRefusedWhereTheIndexIsOfOtherShapes) {
  std::string index = files_.shx.read();
  index.resize(index.size() - 8);
  index[27] = static_cast<char>(index[27] - 4);
  files_.shx.write(index);
  EXPECT_TRUE(says(refusal(), "of city.shx"));
}

TEST_F(Shapefile, IsRefusedWhereARecordIsAnother) {
  change(files_.shx, 100 + 8 + 3, 50);
  EXPECT_TRUE(says(refusal(), "expected record 2 at byte"));
}

TEST_F(Shapefile, IsRefusedWhereTheShapesAreCut) {
  files_.shp.write(files_.shp.read().substr(0, files_.shp.read().size() - 100));
  EXPECT_NE(refusal(), "");
}

TEST_F(Shapefile, IsNamedWhereItsIndexIsMissing) {
  VSIUnlink(files_.shx.path().c_str());
  EXPECT_TRUE(says(refusal(), "its index city.shx is not beside it"));
  EXPECT_TRUE(says(refusal(), "SHAPE_RESTORE_SHX"));
}

TEST_F(Shapefile, IsRefusedWithoutItsTable) {
  VSIUnlink(files_.dbf.path().c_str());
  EXPECT_TRUE(says(refusal(), "the .dbf (their attributes) is not there"));
}

void append(std::string& bytes, auto value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

void append_big(std::string& bytes, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xff);
}

// A shapefile of one patch whose parts are squares of 9 m, each 20 m higher than the one before.
std::string refusal_of_patch(const std::vector<std::int32_t>& kinds) {
  constexpr std::int32_t kMultiPatch = 31;
  const auto parts = static_cast<std::int32_t>(kinds.size());
  std::string content;
  append(content, kMultiPatch);
  for (const double v : {0.0, 0.0, 9.0, 9.0}) append(content, v);
  append(content, parts);
  append(content, 5 * parts);
  for (std::int32_t i = 0; i < parts; ++i) append(content, 5 * i);
  for (const std::int32_t kind : kinds) append(content, kind);
  for (std::int32_t i = 0; i < parts; ++i) {
    for (const double v : {0, 0, 0, 9, 9, 9, 9, 0, 0, 0}) append(content, v);
  }
  append(content, 0.0);
  append(content, 20.0 * parts);
  for (std::int32_t i = 0; i < 5 * parts; ++i) append(content, i / 5 * 20.0);
  const auto file = [&](const std::string& records) {
    std::string bytes;
    append_big(bytes, 9994);
    bytes.resize(24);
    append_big(bytes, static_cast<std::uint32_t>(50 + records.size() / 2));
    append(bytes, 1000);
    append(bytes, kMultiPatch);
    bytes.resize(100);
    return bytes + records;
  };
  const auto words = static_cast<std::uint32_t>(content.size() / 2);
  std::string record;
  append_big(record, 1);
  append_big(record, words);
  std::string index;
  append_big(index, 50);
  append_big(index, words);
  const ShapeFiles files;
  write_layer("ESRI Shapefile", files.shp.path(), {{{{0, 0}, {9, 0}, {9, 9}}, {0, 0, 0}, 5}});
  files.shp.write(file(record + content));
  files.shx.write(file(index));
  return support::refusal_of([&] { read_vector(files.shp.path(), "city.shp", {}); });
}

// GDAL takes them for holes of one another: of a floor and a roof nothing would be left.
TEST(RequireWhole, RefusesRingsOfAPatchWhoseKindIsNotStated) {
  constexpr std::int32_t kOuter = 2, kInner = 3, kFirst = 4, kRing = 5;
  EXPECT_EQ(refusal_of_patch({kOuter, kOuter}), "");
  EXPECT_EQ(refusal_of_patch({kOuter, kInner}), "");
  EXPECT_EQ(refusal_of_patch({kFirst, kRing}), "");
  EXPECT_EQ(refusal_of_patch({kRing}), "");
  for (const auto& kinds : {std::vector{kRing, kRing}, {kOuter, kRing}, {kFirst, kInner}, {7}}) {
    EXPECT_TRUE(
        says(refusal_of_patch(kinds), "of patch 1: expected outer rings that are called so"));
  }
}

// GDAL leaves out solids and meshes of a drawing, and its unit.
TEST(RequireWhole, RefusesADrawing) {
  const std::string text =
      "0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\n0\n100\nAcDbPolyline\n90\n3\n70\n1\n"
      "10\n0\n20\n0\n10\n9\n20\n0\n10\n9\n20\n9\n0\nENDSEC\n0\nEOF\n";
  const std::string said = support::refusal_of([&] { read_text("a.dxf", text, ReadOptions{}); });
  EXPECT_TRUE(says(said, "a.dxf: expected polygons as GeoJSON"));
  EXPECT_TRUE(says(said, "GDAL may leave out parts (DXF)"));
}

TEST(RequireWhole, TakesATableOfWkt) {
  const Source source =
      read_text("a.csv", "WKT,height\n\"POLYGON((0 0,9 0,9 9,0 0))\",12\n", ReadOptions{});
  EXPECT_EQ(source.footprints.size(), 1u);
}

}  // namespace
}  // namespace geom::gis
