#include "traj/check/profile_csv.h"

#include <gtest/gtest.h>

namespace traj {
namespace {

TEST(ProfileRows, HasARowForEachPartAndQuotesAnIdThatNeedsIt) {
  const ClearanceSpan spans[] = {{0, 0.5, 3.25}, {0.5, 1, 0.1}};
  EXPECT_EQ(profile_rows("q1", spans), "q1,0,0.5,3.25\nq1,0.5,1,0.1\n");
  EXPECT_EQ(profile_rows("a,b", std::span(spans).first(1)), "\"a,b\",0,0.5,3.25\n");
  EXPECT_EQ(profile_rows("q1", {}), "");
}

}  // namespace
}  // namespace traj
