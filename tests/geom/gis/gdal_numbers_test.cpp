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

// Of a shapefile of one house whose table has this text as its height.
std::string refusal_of_table(const std::string& height) {
  const ShapeFiles files;
  write_layer("ESRI Shapefile", files.shp.path(), {{{{0, 0}, {9, 0}, {9, 9}}, {0, 0, 0}, 5}});
  std::string table = files.dbf.read();
  const auto first = static_cast<unsigned char>(table[8]);
  const std::size_t size = static_cast<unsigned char>(table[32 + 16]);
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
}

// Of a database of one house whose column of numbers has this height.
std::string refusal_of_database(const char* driver, const std::string& height) {
  const support::TemporaryFolder folder;
  const std::string path = folder / "city.db";
  GDALAllRegister();
  GDALDataset* const made = GetGDALDriverManager()->GetDriverByName(driver)->Create(
      path.c_str(), 0, 0, 0, GDT_Unknown, nullptr);
  char no_index[] = "SPATIAL_INDEX=NO";  // its triggers know functions of the driver alone
  char* options[] = {no_index, nullptr};
  OGRLayer* const layer = made->CreateLayer("city", nullptr, wkbPolygon, options);
  OGRFieldDefn field("height", OFTReal);
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
  }
}

}  // namespace
}  // namespace geom::gis
