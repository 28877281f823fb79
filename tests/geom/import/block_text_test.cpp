#include <gtest/gtest.h>

#include <random>

#include "geom/base/error.h"
#include "geom/import/import_boxes.h"
#include "support/cases.h"
#include "support/reading.h"

namespace geom {
namespace {

ImportedBoxes read(const std::string& text) {
  return import_boxes(support::Text(text), kBlockText, "m.txt");
}

TEST(BlockText, ReadsColoursCommentsAndUnknownWords) {
  const ImportedBoxes text =
      read("# map\n boundary\t0 0 0 9 9 9\nblock 1 1 1 2 2 2 255 0 0 # red\nfog 3\n");
  EXPECT_EQ(text.bounds->max, Vec3(9, 9, 9));
  EXPECT_EQ(text.table.labels[1], "255 0 0");
  EXPECT_EQ(text.skipped.text(), "1 x unknown keyword (line 4: fog)");
}

TEST(BlockText, WantsOneBoundaryAndUprightBlocks) {
  for (const char* bad : {"block 0 0 0 1 1 1\n", "boundary 0 0 0 1 1 1\n",
                          "boundary 0 0 0 1 1 1\nboundary 0 0 0 1 1 1\nblock 0 0 0 1 1 1\n",
                          "boundary 0 0 0 1 1 1\nblock 1 0 0 1 1\n"}) {
    EXPECT_THROW(read(bad), InputError) << bad;
  }
}

TEST(BlockText, NamesTheWordsThatStandInPlaceOfBlocks) {
  const std::string said =
      support::refusal_of([] { read("boundary 0 0 0 9 9 9\nwall 1 1 1 2 2 2\n"); });
  EXPECT_TRUE(support::says(said, "found a boundary and 1 x unknown keyword (line 2: wall)"));
}

TEST(BlockText, TakesCornersInEitherOrder) {
  const ImportedBoxes text = read("boundary 9 9 9 0 0 0\nblock 1 0 5 0 1 1\nblock 1 1 1 2 2 2\n");
  EXPECT_EQ(text.bounds, (Aabb{{0, 0, 0}, {9, 9, 9}}));
  EXPECT_EQ(text.table.boxes[0], (Aabb{{0, 0, 1}, {1, 1, 5}}));
  EXPECT_EQ(text.reversed, 2u);
}

// Ten thousand block texts of which some lines are misspelt: each block is built, refused or
// counted.
TEST(BlockText, NoLineIsLost) {
  std::mt19937 random(3);
  const std::string wrong[] = {"blok",   "Block",  "block:", "BLOCK",
                               "blocks", "window", "b",      "bl ock"};
  for (int i = 0; i < support::cases(10000); ++i) {
    std::string text = "boundary 0 0 0 9 9 9\nblock 0 0 0 1 1 1\n";
    std::size_t built = 1;
    std::size_t odd = 0;
    for (std::size_t k = random() % 6; k > 0; --k) {
      const bool right = random() % 2;
      ++(right ? built : odd);
      text += (right ? "block" : wrong[random() % 8]) + " 1 1 1 2 2 2\n";
    }
    const ImportedBoxes found = read(text);
    ASSERT_EQ(found.table.boxes.size(), built) << text;
    ASSERT_EQ(found.skipped.count(), odd) << text;
  }
}

}  // namespace
}  // namespace geom
