#include "geom/gis/read_footprints.h"

#include <gtest/gtest.h>

#include <fstream>

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

}  // namespace
}  // namespace geom::gis
