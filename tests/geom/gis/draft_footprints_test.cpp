#include "geom/gis/draft_footprints.h"

#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>

#include "support/memory_raster.h"
#include "support/short_memory.h"
#include "support/temporary_folder.h"

namespace geom::gis {
namespace {

constexpr const char* kHouse =
    R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":"EPSG:32632"}},"features":[
{"type":"Feature","properties":{"height":9},"geometry":{"type":"Polygon","coordinates":
[[[500002,5500002],[500012,5500002],[500012,5500012],[500002,5500002]]]}}]})";

// The block on a terrain; whose file is written to when the hashes are made.
std::size_t drafted(const std::string& written) {
  const support::TemporaryFolder folder;
  const std::string path = folder / "block.geojson";
  std::ofstream(path) << kHouse;
  FootprintDraftOptions options;
  options.terrain = folder / "ground.tif";
  support::copy_out(MemoryRaster({}).path(), options.terrain);
  options.open = [&](const std::string& name) {
    if (!written.empty()) std::ofstream(folder / written, std::ios::app) << ' ';
    return open_file(name);
  };
  return draft_footprints(path, options).table.boxes.size();
}

TEST(DraftFootprints, RefusesFilesThatAreWrittenToMeanwhile) {
  EXPECT_GT(drafted(""), 0u);
  EXPECT_THROW(drafted("block.geojson"), std::runtime_error);
  EXPECT_THROW(drafted("ground.tif"), std::runtime_error);
}

}  // namespace
}  // namespace geom::gis
