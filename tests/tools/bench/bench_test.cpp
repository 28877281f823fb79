// The part of skyway-bench that runs another's planner.

#include <gtest/gtest.h>

#include "bench/command.h"

namespace bench {
namespace {

TEST(Command, GetsTheQueriesAndItsLinesAreRead) {
  const CommandOutput out = run_command("cat; echo; printf last; exit 3",
                                        R"({"id":"a"})"
                                        "\n",
                                        1, {});
  ASSERT_EQ(out.answers.lines.size(), 2u);
  EXPECT_EQ(out.answers.lines[0], R"({"id":"a"})");
  EXPECT_EQ(out.answers.lines[1], "last");
  EXPECT_EQ(out.status, 3);
  EXPECT_GT(out.answers.peak_rss, 0u);
  EXPECT_EQ(run_command("kill -9 $$", "", 0, {}).status, 128 + 9);
}

}  // namespace
}  // namespace bench
