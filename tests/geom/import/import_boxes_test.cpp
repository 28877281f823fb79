#include "geom/import/import_boxes.h"

#include <gtest/gtest.h>

#include "geom/base/error.h"
#include "support/reading.h"

namespace geom {
namespace {

constexpr const char* kTable =
    "lat0 37, lon0 -122\nposX,posY,posZ,halfSizeX,halfSizeY,halfSizeZ\n10,20,5.5,5,5,5\n";
constexpr const char* kBlocks = "# a room\nboundary 0 0 0 10 10 4\nblock 1 1 1 2 2 2 200 0 0\n";

ImportedBoxes imported(const std::string& text) {
  return import_boxes(support::Text(text), box_format_of(text, "it"), "it");
}

TEST(ImportBoxes, KnowsFormatsByTheirFirstLine) {
  EXPECT_EQ(&box_format_of(kTable, "it"), &kFcnd);
  EXPECT_EQ(&box_format_of(kBlocks, "it"), &kBlockText);
  EXPECT_EQ(&box_format_of("min_x_m,min_y_m\n", "it"), &kBoxCsv);
  EXPECT_EQ(&box_format_of(" {\"bounds\":", "it"), &kRotorPyWorld);
  EXPECT_EQ(&box_format_of("voxel 3 4 5\n", "it"), &kVoxelMap);
  EXPECT_EQ(&box_format_of("# Octomap OcTree binary file\n", "it"), &kOctomapTree);
  EXPECT_EQ(&box_format_of("\xef\xbb\xbf<?xml version=\"1.0\"?>\n<sdf version='1.9'>", "it"),
            &kGazeboWorld);
  EXPECT_EQ(&box_format_of("# c\n- origin: [0, 0, 0]\n", "it"), &kJps3d);
  EXPECT_THROW(box_format_of("<html>", "it"), InputError);
  EXPECT_THROW(box_format_of("<sdfx>", "it"), InputError);
}

TEST(ImportBoxes, SaysWhatTheFormatSays) {
  const ImportedBoxes table = imported(kTable);
  EXPECT_EQ(table.frame.axes, Axes::neu);
  EXPECT_EQ(table.frame.origin->latitude, 37);
  EXPECT_EQ(table.floor, 0);
  EXPECT_FALSE(table.bounds);
  const ImportedBoxes blocks = imported(kBlocks);
  EXPECT_EQ(blocks.frame.axes, Axes::enu);
  EXPECT_EQ(blocks.bounds, (Aabb{{0, 0, 0}, {10, 10, 4}}));
  EXPECT_EQ(blocks.table.labels, (std::vector<std::string>{"", "200 0 0"}));
}

// The table's box hangs half a metre above the floor, which such tables do by rounding.
TEST(ImportBoxes, MakesTheMapThatTheFormatMeans) {
  const MadeMap made = make_map(imported(kTable), "it");
  EXPECT_EQ(made.sealed, 1u);
  EXPECT_EQ(made.map.boxes()[0].min.z(), 0);
  const MadeMap room = make_map(imported(kBlocks), "it");
  EXPECT_EQ(room.map.spec().bounds, (Aabb{{0, 0, 0}, {10, 10, 4}}));
  EXPECT_EQ(room.map.spec().bounds_from, "source");
}

TEST(ImportBoxes, MakesNoMapOfWhatItSkipped) {
  ImportedBoxes boxes = imported(std::string(kBlocks) + "blok 5 5 0 6 6 4\n");
  EXPECT_THROW(make_map(boxes, "it"), InputError);
  boxes.allow_skipped = true;
  const MadeMap made = make_map(boxes, "it");
  EXPECT_EQ(made.map.size(), 1u);
  EXPECT_EQ(made.map.spec().history, R"([{"skipped":1}])");  // the map remembers
}

TEST(ImportBoxes, SealsOnlyWhereNothingElseIsAsked) {
  MakeMapOptions options;
  options.seal = 0;
  EXPECT_EQ(make_map(imported(kTable), "it", options).sealed, 0u);
}

}  // namespace
}  // namespace geom
