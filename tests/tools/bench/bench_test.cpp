// The part of skyway-bench that runs another's planner.

#include <gtest/gtest.h>

#include "bench/command.h"

namespace bench {
namespace {

TEST(Command, GetsTheQueriesAndItsLinesAreRead) {
  const CommandOutput out = run_command("cat; echo; printf last; exit 3",
                                        to_json_lines({{"a", {1, 2, 3}, {4, 5, 6}}}), 1, {});
  ASSERT_EQ(out.lines.size(), 2u);
  EXPECT_EQ(out.lines[0], R"({"id":"a","from":[1,2,3],"to":[4,5,6]})");
  EXPECT_EQ(out.lines[1], "last");
  EXPECT_EQ(out.status, 3);
  EXPECT_GT(out.peak_rss, 0u);
  EXPECT_EQ(run_command("kill -9 $$", "", 0, {}).status, 128 + 9);
}

}  // namespace
}  // namespace bench
