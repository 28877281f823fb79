#include "import/block_text.h"

#include <gtest/gtest.h>

#include <random>
#include <sstream>

#include "geom/base/error.h"
#include "support/built_and_skipped.h"
#include "support/cases.h"

namespace geom {
namespace {

TEST(BlockText, ReadsColoursCommentsAndUnknownWords) {
  std::istringstream in("# map\n boundary\t0 0 0 9 9 9\nblock 1 1 1 2 2 2 255 0 0 # red\nfog 3\n");
  const ImportedBoxes text = read_block_text(in, "m.txt");
  EXPECT_EQ(text.bounds->max, Vec3(9, 9, 9));
  EXPECT_EQ(text.table.labels[1], "255 0 0");
  EXPECT_EQ(text.skipped.text(), "1 x unknown keyword (line 4: fog)");
}

TEST(BlockText, WantsOneBoundaryAndUprightBlocks) {
  for (const char* bad : {"block 0 0 0 1 1 1\n", "boundary 0 0 0 1 1 1\n",
                          "boundary 0 0 0 1 1 1\nboundary 0 0 0 1 1 1\nblock 0 0 0 1 1 1\n",
                          "boundary 0 0 0 1 1 1\nblock 1 0 0 1 1\n"}) {
    std::istringstream in(bad);
    EXPECT_THROW(read_block_text(in, "m.txt"), InputError) << bad;
  }
}

TEST(BlockText, TakesCornersInEitherOrder) {
  std::istringstream in("boundary 9 9 9 0 0 0\nblock 1 0 5 0 1 1\nblock 1 1 1 2 2 2\n");
  const ImportedBoxes text = read_block_text(in, "m.txt");
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
    ASSERT_EQ(support::built_and_skipped(read_block_text, text), (std::pair{built, odd})) << text;
  }
}

}  // namespace
}  // namespace geom
