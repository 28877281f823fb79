#include "text/line_blocks.h"

#include <gtest/gtest.h>

#include <sstream>

#include "geom/base/file_error.h"
#include "support/random_city.h"

namespace geom {
namespace {

TEST(LineBlocks, AreTheWholeTextInWholeLinesThatAreCounted) {
  support::Random random(6);
  for (int i = 0; i < 40; ++i) {
    std::string text;
    std::size_t lines = 0;
    for (int size = random.below(600000); size > 0; ++lines) {
      const int length = random.below(20) ? random.below(60) : random.below(300000);
      text += std::string(static_cast<std::size_t>(length), 'x') + '\n';
      size -= length + 1;
    }
    if (i % 2) text += "no line feed", ++lines;
    std::istringstream in(text);
    LineBlocks blocks(in, 3, "t.csv");
    std::string found;
    LineBlock block;
    while (blocks.next(block)) {
      EXPECT_EQ(block.before + block.lines, blocks.lines());
      EXPECT_TRUE(block.text.ends_with('\n') || found.size() + block.text.size() == text.size());
      EXPECT_GE(block.lines, 1u);
      found += block.text;
    }
    EXPECT_EQ(found, text);
    EXPECT_EQ(blocks.lines(), 3 + lines);
    EXPECT_FALSE(blocks.next(block));
  }
}

TEST(LineBlocks, ThrowWhereReadingFails) {
  std::istringstream in("a\n");
  in.setstate(std::ios::badbit);
  LineBlocks blocks(in, 0, "t.csv");
  LineBlock block;
  EXPECT_THROW(blocks.next(block), FileError);
}

}  // namespace
}  // namespace geom
