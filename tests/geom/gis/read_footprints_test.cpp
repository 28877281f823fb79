#include "geom/gis/read_footprints.h"

#include <gtest/gtest.h>

#include <fstream>

#include "support/memory_raster.h"
#include "support/reading.h"
#include "support/short_memory.h"
#include "support/temporary_folder.h"

namespace geom::gis {
namespace {

constexpr const char* kBlock =
    R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":"EPSG:25832"}},"features":[
{"type":"Feature","properties":{"height":9},"geometry":{"type":"Polygon","coordinates":
[[[500000,5500000],[500010,5500000],[500010,5500010],[500000,5500000]]]}}]})";

class ReadFootprintsTest : public testing::Test {
 protected:
  ReadFootprintsTest() { std::ofstream(path_) << kBlock; }

  support::TemporaryFolder folder_;
  std::string path_ = folder_ / "block.geojson";
};

TEST_F(ReadFootprintsTest, AreRefusedWhereAnAllocationFailsInSilence) {
  support::expect_bad_alloc_where_one_is_swallowed([&] {
    EXPECT_EQ(read(kVector, {path_, path_, support::Text(kBlock)}, {}).footprints.size(), 1u);
  });
}

TEST_F(ReadFootprintsTest, HaveNoFormatWhereAnAllocationFailsInSilence) {
  support::expect_bad_alloc_where_one_is_swallowed(
      [&] { EXPECT_EQ(&footprint_format_of(kBlock, path_), &kVector); });
}

TEST(ReadRaster, WarnsOfCompressionThatMayChangeHeights) {
  GDALAllRegister();
  GDALDriver& driver = *GetGDALDriverManager()->GetDriverByName("GTiff");
  for (const char* const compression : {"COMPRESS=DEFLATE", "COMPRESS=LERC"}) {
    const MemoryFile file("compressed.tif");
    char* options[] = {const_cast<char*>(compression), nullptr};
    GDALDataset* const made = driver.Create(file.path().c_str(), 4, 4, 1, GDT_Float32, options);
    double transform[] = {500000, 5, 0, 5500020, 0, -5};
    made->SetGeoTransform(transform);
    MemoryRaster::fill(*made->GetRasterBand(1), [](int, int) { return 7; });
    GDALClose(made);
    const bool lerc = compression == std::string("COMPRESS=LERC");
    EXPECT_EQ(read_raster(file.path(), "r", {}).warnings.size(), lerc ? 1u : 0u);
  }
}

TEST(ReadRaster, TakesNoValueForNoneForAHeight) {
  const auto refusal = [](double none, double beside) {
    const MemoryRaster raster({.cell = [=](int column, int row) {
      return column == 1 && row == 2 ? none : beside + column;
    }});
    return support::refusal_of([&] { read_raster(raster.path(), "r", {}); });
  };
  EXPECT_TRUE(support::says(refusal(-9999, 40), "row 2, column 1: expected a height, found -9999"));
  EXPECT_TRUE(support::says(refusal(-999, 40), "row 2, column 1: expected a height, found -999"));
  EXPECT_EQ(refusal(-998, 40), "");
  EXPECT_EQ(refusal(-999, -1003), "");  // of a sea
}

}  // namespace
}  // namespace geom::gis
