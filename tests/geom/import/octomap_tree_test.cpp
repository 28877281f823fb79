#include <gtest/gtest.h>

#include "geom/import/import_boxes.h"
#include "support/reading.h"

namespace geom {
namespace {

constexpr unsigned kFree = 1;
constexpr unsigned kOccupied = 2;
constexpr unsigned kInner = 3;

// Two bits for each of a node's children, as octants by x, y and z.
std::string node(std::initializer_list<std::pair<int, unsigned>> children) {
  unsigned bits = 0;
  for (const auto& [octant, what] : children) bits |= what << (2 * octant);
  return {static_cast<char>(bits & 255), static_cast<char>(bits >> 8)};
}

// At this resolution the octants of the root have sides of 1 m.
std::string tree(const std::string& nodes, const std::string& res = "0.000030517578125") {
  return "# Octomap OcTree binary file\nid OcTree\nsize 1\nres " + res + "\ndata\n" + nodes;
}

ImportedBoxes read(const std::string& bytes, bool unknown_blocked = false) {
  return import_boxes(support::Text(bytes), kOctomapTree, "t.bt",
                      {.unknown_blocked = unknown_blocked});
}

TEST(Octomap, LeavesAreBoxesOfTheirOctants) {
  const ImportedBoxes map = read(tree(node({{0, kOccupied}, {5, kOccupied}, {7, kFree}})));
  ASSERT_EQ(map.table.boxes.size(), 2u);
  EXPECT_EQ(map.table.boxes[0], (Aabb{{-1, -1, -1}, {0, 0, 0}}));
  EXPECT_EQ(map.table.boxes[1], (Aabb{{0, -1, 0}, {1, 0, 1}})) << "octant 5: east and up";
  EXPECT_EQ(map.table.ids, (std::vector<std::uint64_t>{0, 1}));
  EXPECT_EQ(map.bounds, (Aabb{{-1, -1, -1}, {1, 1, 1}}));
  EXPECT_EQ(map.unknown, 5u);
}

TEST(Octomap, InnerNodesAreHalvedAndBoundsAreOfWhatWasSeen) {
  const ImportedBoxes map = read(tree(node({{7, kInner}}) + node({{0, kOccupied}, {1, kFree}})));
  ASSERT_EQ(map.table.boxes.size(), 1u);
  EXPECT_EQ(map.table.boxes[0], (Aabb{{0, 0, 0}, {0.5, 0.5, 0.5}}));
  EXPECT_EQ(map.bounds, (Aabb{{0, 0, 0}, {1, 0.5, 0.5}}));
  EXPECT_EQ(map.unknown, 0u);
}

TEST(Octomap, CellsNeverSeenAreBlockedWhereAsked) {
  const std::string bytes = tree(node({{0, kOccupied}, {7, kFree}}));
  EXPECT_EQ(read(bytes).table.boxes.size(), 1u);
  const ImportedBoxes map = read(bytes, true);
  ASSERT_EQ(map.table.boxes.size(), 7u);
  for (std::size_t i = 0; i < 7; ++i) {
    EXPECT_EQ(map.table.labels[map.table.label[i]], i == 0 ? "" : "unknown") << i;
    EXPECT_FALSE(contains(map.table.boxes[i], {0.5, 0.5, 0.5})) << "seen, and free";
  }
}

TEST(Octomap, RefusesOtherFilesAndTreesThatDoNotEndWhereTheyShould) {
  const std::string good = node({{0, kOccupied}});
  std::string deep;
  for (int level = 0; level < 17; ++level) deep += node({{0, kInner}});
  for (const std::string& bad :
       {std::string(), std::string("# Octomap OcTree file\n"), tree(good.substr(1)),
        tree(good + "x"), tree(good, "0"), tree(good, "-1"), tree(good, "nan"), tree(node({})),
        tree(node({{0, kInner}, {1, kOccupied}}) + node({})), tree(node({{0, kInner}})), tree(deep),
        tree(node({{0, kFree}}))}) {
    EXPECT_TRUE(support::refusal_of([&] { read(bad); }).starts_with("t.bt: ")) << bad;
  }
}

}  // namespace
}  // namespace geom
