#include "gis/gdal_numbers.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "geom/gis/footprint_source.h"
#include "support/memory_file.h"
#include "support/reading.h"
#include "support/shape_files.h"
#include "support/temporary_folder.h"

namespace geom::gis {
namespace {

using support::refusal_of;
using support::says;

// Of a shapefile of one house whose table has this text as its height, in a column of so many
// digits behind the point.
std::string refusal_of_table(const std::string& height, char digits = 15) {
  const ShapeFiles files;
  write_layer("ESRI Shapefile", files.shp.path(), {{{{0, 0}, {9, 0}, {9, 9}}, {0, 0, 0}, 5}});
  std::string table = files.dbf.read();
  const auto first = static_cast<unsigned char>(table[8]);
  const std::size_t size = static_cast<unsigned char>(table[32 + 16]);
  table[32 + 17] = digits;
  table.replace(first + 1U, size, height + std::string(size - height.size(), ' '));
  files.dbf.write(table);
  return refusal_of([&] { read_vector(files.shp.path(), "city.shp", {}); });
}

TEST(RequireWholeNumbers, RefusesATableThatHoldsNone) {
  for (const char* number : {"12.5", "  12", "1.5e2", "-3", ""}) {
    EXPECT_EQ(refusal_of_table(number), "") << number;
  }
  for (const char* other : {"12,5", "1,250.5", "12 50", "0x20", "12.5 m", "*****"}) {
    EXPECT_TRUE(says(refusal_of_table(other),
                     fmt::format("column \"height\": expected numbers, found \"{}\"", other)));
  }
  for (const char* whole : {"12", " -3", "12.0", ""}) EXPECT_EQ(refusal_of_table(whole, 0), "");
  for (const char* cut : {"10.9", "1.5e2"}) {
    EXPECT_TRUE(says(refusal_of_table(cut, 0), fmt::format("found \"{}\"", cut)));
  }
}

// Of a database of one house whose column of numbers of this type has this height.
std::string refusal_of_database(const char* driver, const std::string& height,
                                OGRFieldType type = OFTReal) {
  const support::TemporaryFolder folder;
  const std::string path = folder / "city.db";
  GDALAllRegister();
  GDALDataset* const made = GetGDALDriverManager()->GetDriverByName(driver)->Create(
      path.c_str(), 0, 0, 0, GDT_Unknown, nullptr);
  char no_index[] = "SPATIAL_INDEX=NO";  // its triggers know functions of the driver alone
  char* options[] = {no_index, nullptr};
  OGRLayer* const layer = made->CreateLayer("city", nullptr, wkbPolygon, options);
  OGRFieldDefn field("height", type);
  EXPECT_EQ(layer->CreateField(&field), OGRERR_NONE);
  made->ExecuteSQL(fmt::format("INSERT INTO city (height) VALUES ({})", height).c_str(), nullptr,
                   nullptr);
  GDALClose(made);
  return refusal_of([&] { read_vector(path, "city.db", {}); });
}

TEST(RequireWholeNumbers, RefusesADatabaseThatHoldsText) {
  for (const char* driver : {"GPKG", "SQLite"}) {
    for (const char* number : {"12.5", "'12.5'", "NULL", "' '"}) {
      EXPECT_EQ(refusal_of_database(driver, number), "") << driver << number;
    }
    EXPECT_TRUE(says(refusal_of_database(driver, "'12,5'"),
                     "column \"height\": expected numbers, found \"12,5\""))
        << driver;
    EXPECT_EQ(refusal_of_database(driver, "12.0", OFTInteger), "") << driver;
    EXPECT_TRUE(says(refusal_of_database(driver, "10.9", OFTInteger), "found \"10.9\"")) << driver;
  }
}

std::string refusal_of_text(const std::string& file, const std::string& text) {
  const MemoryFile made(file, text);
  return refusal_of([&] { read_vector(made.path(), file, {}); });
}

// Of a house whose height, of the type that Esri calls so, is written like this.
std::string refusal_of_esri(const std::string& type, const std::string& height) {
  return refusal_of_text(
      "city.json",
      fmt::format(R"({{"geometryType":"esriGeometryPolygon","fields":[{{"name":"height",)"
                  R"("type":"esriFieldType{}"}}],"features":[{{"attributes":{{"height":{}}},)"
                  R"("geometry":{{"rings":[[[0,0],[0,9],[9,9],[0,0]]]}}}}]}})",
                  type, height));
}

TEST(RequireWholeNumbers, RefusesEsriJsonThatHoldsNone) {
  for (const char* number : {"10", "10.0", "null"}) {
    EXPECT_EQ(refusal_of_esri("Integer", number), "") << number;
  }
  EXPECT_EQ(refusal_of_esri("Double", "10.9"), "");
  EXPECT_TRUE(says(refusal_of_esri("Integer", "10.9"), "expected whole numbers, found \"10.9\""));
  EXPECT_TRUE(says(refusal_of_esri("SmallInteger", "\"10.9\""), "found \"10.9\""));
  EXPECT_TRUE(says(refusal_of_esri("Double", "\"10 km\""), "found \"10 km\""));
}

TEST(RequireWholeNumbers, RefusesKmlThatHoldsNone) {
  const auto refusal = [](const std::string& type, const std::string& height) {
    return refusal_of_text(
        "city.kml",
        "<kml xmlns=\"http://www.opengis.net/kml/2.2\"><Document><Schema name=\"s\" id=\"s\">"
        "<SimpleField name=\"height\" type=\"" +
            type +
            "\"/></Schema><Placemark><ExtendedData><SchemaData schemaUrl=\"#s\"><SimpleData "
            "name=\"height\">" +
            height +
            "</SimpleData></SchemaData></ExtendedData><Polygon><outerBoundaryIs><LinearRing>"
            "<coordinates>0,0 1,0 1,1 0,0</coordinates></LinearRing></outerBoundaryIs></Polygon>"
            "</Placemark></Document></kml>");
  };
  EXPECT_EQ(refusal("int", " 10 "), "");
  EXPECT_EQ(refusal("double", "10.9"), "");
  EXPECT_EQ(refusal("string", "10 ft"), "");
  EXPECT_TRUE(says(refusal("int", "10.9"), "expected whole numbers, found \"10.9\""));
  EXPECT_TRUE(says(refusal("double", "0.1 km"), "expected numbers, found \"0.1 km\""));
}

// It makes text numbers, which GDAL then cuts: "10.9" in a column of whole ones, "0.1 km" in any.
TEST(RequireWholeNumbers, RefusesTypesBesideACsv) {
  const std::string table = "WKT,height\n\"POLYGON((0 0,9 0,9 9,0 0))\",10.9\n";
  EXPECT_EQ(refusal_of_text("city.csv", table), "");
  for (const char* type : {"Integer", "Real"}) {
    const MemoryFile types("city.csvt", fmt::format("\"String\",\"{}\"\n", type));
    EXPECT_TRUE(says(refusal_of_text("city.csv", table), "found numbers, as the .csvt beside it"));
  }
  const MemoryFile types("city.csvt", "\"String\",\"String\"\n");
  EXPECT_EQ(refusal_of_text("city.csv", table), "");
}

}  // namespace
}  // namespace geom::gis
