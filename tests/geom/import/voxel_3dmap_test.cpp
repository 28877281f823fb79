#include <gtest/gtest.h>

#include "geom/import/import_boxes.h"
#include "support/reading.h"

namespace geom {
namespace {

ImportedBoxes read(const std::string& text) {
  return import_boxes(support::Text(text), kVoxelMap, "w.3dmap");
}

TEST(Voxel3dmap, EachVoxelIsAUnitBoxWithTheNumberOfItsLine) {
  const ImportedBoxes map = read("voxel 4 5 6\r\n0 0 0\n\n 3\t4 5 \n");
  EXPECT_EQ(map.bounds, (Aabb{{0, 0, 0}, {4, 5, 6}}));
  EXPECT_EQ(map.table.boxes, (std::vector<Aabb>{{{0, 0, 0}, {1, 1, 1}}, {{3, 4, 5}, {4, 5, 6}}}));
  EXPECT_EQ(map.table.ids, (std::vector<std::uint64_t>{2, 4}));
}

TEST(Voxel3dmap, RefusesWhatIsNoSuchWorldAtItsLine) {
  const auto line = [](const std::string& text) {
    const std::string said = support::refusal_of([&] { read(text); });
    return said.substr(0, said.find(": "));
  };
  EXPECT_EQ(line("pixel 4 5 6\n0 0 0\n"), "w.3dmap:1");
  EXPECT_EQ(line("voxel 4 5\n0 0 0\n"), "w.3dmap:1");
  EXPECT_EQ(line("voxel 4 0 6\n0 0 0\n"), "w.3dmap:1");
  EXPECT_EQ(line("voxel 4 5 6\n0 0 0\n4 0 0\n"), "w.3dmap:3") << "outside";
  EXPECT_EQ(line("voxel 4 5 6\n0 -1 0\n"), "w.3dmap:2");
  EXPECT_EQ(line("voxel 4 5 6\n0 0.5 0\n"), "w.3dmap:2");
  EXPECT_EQ(line("voxel 4 5 6\n0 0 0 0\n"), "w.3dmap:2");
  EXPECT_EQ(line("voxel 4 5 6\n\n"), "w.3dmap:2") << "nothing filled";
}

}  // namespace
}  // namespace geom
