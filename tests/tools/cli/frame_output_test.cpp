#include "cli/file/frame_output.h"

#include <gtest/gtest.h>

#include "cli/answer/exit.h"

namespace {

TEST(FrameOutput, NumbersNames) {
  EXPECT_EQ(cli::numbered("a-%05d.png", 12), "a-00012.png");
  EXPECT_EQ(cli::numbered("a%d", 7), "a7");
  EXPECT_EQ(cli::numbered("%s.png", 7), "%s.png");
  EXPECT_THROW(cli::FrameOutput("%n.png", 2, false), cli::UsageError);
  EXPECT_NO_THROW(cli::FrameOutput("one.png", 1, false));
}

}  // namespace
