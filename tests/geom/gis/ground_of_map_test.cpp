#include "geom/gis/ground_of_map.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>

#include "support/memory_raster.h"
#include "support/short_memory.h"
#include "support/temporary_folder.h"

namespace geom::gis {
namespace {

class GroundOfMapTest : public testing::Test {
 protected:
  GroundOfMapTest() {
    const MemoryRaster raster({.columns = 40,
                               .rows = 40,
                               .cell = [](int column, int row) { return column + 0.1 * row; },
                               .transform = {500000, 5, 0, 5500200, 0, -5}});
    support::copy_out(raster.path(), path_);
    spec_.bounds = {{-20, -20, 0}, {20, 20, 90}};
    spec_.frame.origin = GeodeticOrigin{49.65139, 9.00138, 0};  // the raster's middle
  }

  std::string ground(const OpenFile& open = open_file) const {
    const GroundModel made = ground_of_map(path_, spec_, {.cell = 10, .error = 1, .open = open});
    const auto range = made.range({{-20, -20}, {20, 20}});
    return fmt::format("{} {} {}", range.low, range.high, range.all_known);
  }

  support::TemporaryFolder folder_;
  std::string path_ = folder_ / "ground.tif";
  BoxMapSpec spec_;
};

TEST_F(GroundOfMapTest, HasNoTerrainWhereAnAllocationFailsInSilence) {
  support::expect_bad_alloc_where_one_is_swallowed([&] { Terrain(path_, path_, {}); });
}

TEST_F(GroundOfMapTest, IsRefusedWhereTheFileIsWrittenTo) {
  EXPECT_NO_THROW(ground());
  const auto written = [&](const std::string& name) {
    std::ofstream(path_, std::ios::app) << ' ';
    return open_file(name);
  };
  EXPECT_THROW(ground(written), std::runtime_error);
}

}  // namespace
}  // namespace geom::gis
