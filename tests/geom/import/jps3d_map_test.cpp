#include <gtest/gtest.h>

#include "geom/import/import_boxes.h"
#include "support/reading.h"

namespace geom {
namespace {

ImportedBoxes read(const std::string& text, bool unknown_blocked = false) {
  return import_boxes(support::Text(text), kJps3d, "m.yaml", {.unknown_blocked = unknown_blocked});
}

const std::string kHead =
    "- start: [0, 0, 0]\n- origin: [1, 2, 3]\n- dim: [2, 1, 2]\n- resolution: 0.5\n";

TEST(Jps3dMap, IsABoxAnOccupiedCellXFastest) {
  const ImportedBoxes map =
      read("# a map\n" + kHead + "- data: [0, 1, # comment\n  -1,\n  100, ]\n");
  ASSERT_EQ(map.table.boxes.size(), 2u);
  EXPECT_EQ(map.table.boxes[0], (Aabb{{1.5, 2, 3}, {2, 2.5, 3.5}}));
  EXPECT_EQ(map.table.boxes[1], (Aabb{{1.5, 2, 3.5}, {2, 2.5, 4}}));
  EXPECT_EQ(map.table.ids, (std::vector<std::uint64_t>{1, 3}));
  EXPECT_EQ(map.bounds, (Aabb{{1, 2, 3}, {2, 2.5, 4}}));
  EXPECT_EQ(map.unknown, 1u);
  EXPECT_EQ(map.largest_change, 0);
}

TEST(Jps3dMap, BlocksUnknownCellsWhereAsked) {
  const ImportedBoxes map = read(kHead + "- data: [0, 1, -1, 0]", true);
  ASSERT_EQ(map.table.boxes.size(), 2u);
  EXPECT_EQ(map.table.labels[map.table.label[1]], "unknown");
}

TEST(Jps3dMap, RoundsFacesOutward) {
  const ImportedBoxes map =
      read("origin: [0.1, 0, 0]\ndim: [3, 1, 1]\nresolution: 0.1\ndata: [0, 0, 1]\n");
  EXPECT_LE(map.table.boxes[0].min.x(), 0.3);
  EXPECT_GE(map.table.boxes[0].max.x(), 0.4);
  EXPECT_GT(map.largest_change, 0);
  EXPECT_LT(map.largest_change, 1e-15);
}

TEST(Jps3dMap, RefusesOtherYaml) {
  const std::string data = "- data: [0, 1, 0, 0]\n";
  EXPECT_EQ(support::refusal_of([&] { read(kHead + data); }), "");
  for (const std::string& bad :
       {std::string(),
        kHead,
        kHead + "- data: [0, 1, 0]\n",
        kHead + "- data: [0, 0, 0, 0]\n",
        kHead + "- data: [0, 1, 0, 0",
        kHead + "- data: [0 1 0 0]\n",
        kHead + "- data: 1\n",
        kHead + "- data: [0, 1, nan, 0]\n",
        kHead + "- data: [0, 1, 1x, 0]\n",
        kHead + data + data,
        kHead + data + "- colour: 3\n",
        kHead + data + "more\n",
        kHead + "- data: [0, 1, 0, 0] 7\n",
        kHead + "- data: {0, 1}\n",
        std::string("- origin: [1, 2]\n- dim: [2, 2]\n- resolution: 1\n- data: [1, 1, 1, 1]\n"),
        std::string("- origin: [1, 2, 3]\n- dim: [1, 1, 1]\n- resolution: 0\n- data: [1]\n"),
        std::string("- origin: [1, 2, 3]\n- dim: [1, 1, -1]\n- resolution: 1\n- data: [1]\n"),
        std::string("- origin: [1, 2, 3]\n- dim: [1, 1, 1.5]\n- resolution: 1\n- data: [1]\n"),
        std::string(
            "- origin: [1, 2, 3]\n- dim: [999999, 999999, 999999]\n- resolution: 1\n- data: [1]\n"),
        std::string("- origin: [1, 2, 3]\n- dim: [1, 1, 1]\n- resolution: 1e8\n- data: [1]\n")}) {
    EXPECT_NE(support::refusal_of([&] { read(bad); }), "") << bad;
  }
  EXPECT_EQ(support::refusal_of([&] { read(kHead + "- data: [0, 1, 0]\n"); }),
            "m.yaml:5: data must have the 4 numbers that dim says, found 3");
}

// A comment would swallow what another program reads.
TEST(Jps3dMap, RefusesACarriageReturnAlone) {
  EXPECT_NE(support::refusal_of([] { read("# a map\r" + kHead + "- data: [0, 0, 1, 0]\n"); }), "");
  EXPECT_EQ(read("# a map\r\n" + kHead + "- data: [0, 0, 1, 0]\r\n").table.boxes.size(), 1u);
}

}  // namespace
}  // namespace geom
